% Figure 3: 64 globes without a point light. Only the ambient light shows them, dimmed. With lights they are "worlds".
% Report: lights (2.2).

image {
  resolution 640 480
  aa 0 2
  samples 1
}

