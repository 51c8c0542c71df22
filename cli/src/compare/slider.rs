use super::page::Picture;
use crate::accuracy::page::escaped;

/// One picture over the other, and a slider that says how much of it is seen: a range input, which mouse, finger and arrow keys move. Without
/// scripts the left half is one and the right half the other.
pub(super) fn slider(left: &Picture, right: &Picture) -> String {
    let Picture { width, height, .. } = left;
    format!(
        "<figure class=\"slider\" style=\"--share:50%;max-width:{width}px\">\n<div class=\"stack\">\
         <img class=\"right\" width=\"{width}\" height=\"{height}\" alt=\"{right_alt}\" src=\"{}\">\
         <img class=\"left\" width=\"{width}\" height=\"{height}\" alt=\"{left_alt}\" src=\"{}\"></div>\n\
         <input type=\"range\" min=\"0\" max=\"100\" step=\"0.5\" value=\"50\" aria-label=\"Where the one picture ends and the other begins, in per cent\">\n\
         <figcaption><span>{left_alt}</span><span>{right_alt}</span></figcaption>\n</figure>\n",
        right.source,
        left.source,
        left_alt = escaped(&left.alt),
        right_alt = escaped(&right.alt),
    )
}
