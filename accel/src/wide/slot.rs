//! The slots of wide nodes, read from the cuts that were found to be cheapest.

use geometry::Aabb;

use super::{
    cells::Cell,
    collapse::{Shown, Union, WHOLE, covers, lone_eighth},
    layout::SLOTS,
};

/// What is shown in one slot of a node.
#[derive(Clone, Copy)]
pub(super) struct Slot<'a> {
    pub(super) cell: &'a Cell,
    /// Of the cell's eighths; of a cell that is not divided, the whole.
    pub(super) union: Union,
}

impl<'a> Slot<'a> {
    /// All that is in a cell.
    pub(super) fn whole(cell: &'a Cell) -> Self {
        Self { cell, union: WHOLE }
    }

    /// The cells that it shows.
    pub(super) fn cells(self) -> impl Iterator<Item = &'a Cell> {
        let eighth = move |place| self.cell.divided.as_ref()?.eighth(place).filter(|_| covers(self.union, place));
        let itself = if self.cell.divided.is_none() { Some(self.cell) } else { None };
        (0..8).filter_map(eighth).chain(itself)
    }

    pub(super) fn bounds(self) -> Aabb {
        self.cells().fold(Aabb::EMPTY, |all, cell| all.union(cell.bounds))
    }

    /// A cell's eighths, each in a slot of its own.
    pub(super) fn eighths(self) -> [Option<Self>; SLOTS] {
        let eighth = |place| self.cell.divided.as_ref()?.eighth(place).map(Self::whole);
        std::array::from_fn(|slot| if slot < 8 { eighth(slot) } else { None })
    }

    /// How many references in it are asked one by one.
    pub(super) fn asked(self) -> u32 {
        self.cells().map(|cell| cell.asked).sum()
    }

    /// How many references are in it.
    pub(super) fn count(self) -> u32 {
        self.cells().map(|cell| cell.count).sum()
    }

    /// The same without what is empty: a union with one part empty is the other part.
    pub(super) fn settled(self) -> Self {
        let Some(divided) = &self.cell.divided else { return self };
        if let Some(place) = lone_eighth(self.union) {
            return divided.eighth(place).map_or(self, |cell| Self::whole(cell).settled());
        }
        match divided.cuts.shown(self.union, 1) {
            Shown::Cut { lower, upper, lower_slots } => {
                Self { union: if lower_slots > 0 { lower } else { upper }, ..self }.settled()
            }
            _ => self,
        }
    }

    /// Whether it is a leaf.
    pub(super) fn is_leaf(self) -> bool {
        self.cell.divided.as_ref().is_none_or(|divided| divided.cuts.shown(self.union, 1) == Shown::Leaf)
    }
}

/// The slots in which a slot's content is best shown, at most so many.
pub(super) fn cut(slot: Slot, most: usize) -> [Option<Slot>; SLOTS] {
    let mut slots = [None; SLOTS];
    cut_into(slot, most, &mut slots.iter_mut());
    slots
}

fn cut_into<'a, 's>(slot: Slot<'a>, most: usize, slots: &mut impl Iterator<Item = &'s mut Option<Slot<'a>>>)
where
    'a: 's,
{
    let Some(divided) = &slot.cell.divided else {
        slots.next().expect("a slot for each").replace(slot);
        return;
    };
    if let Some(place) = lone_eighth(slot.union) {
        if let Some(cell) = divided.eighth(place) {
            cut_into(Slot { cell, union: WHOLE }, most, slots);
        }
        return;
    }
    match divided.cuts.shown(slot.union, most) {
        Shown::Leaf | Shown::Node => {
            slots.next().expect("a slot for each").replace(slot);
        }
        Shown::Fewer => cut_into(slot, most - 1, slots),
        Shown::Cut { lower, upper, lower_slots } => {
            for (union, most) in [(lower, lower_slots), (upper, most - lower_slots)] {
                if most > 0 {
                    cut_into(Slot { union, ..slot }, most, slots);
                }
            }
        }
    }
}
