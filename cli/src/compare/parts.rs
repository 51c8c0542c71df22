use clap::ValueEnum;

use crate::parts::Part;

/// What `--with` names: a part, or several at once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Parts {
    One(Part),
    /// The four of the report.
    Shaders,
    All,
}

impl Parts {
    /// Each of them.
    pub(crate) fn parts(self) -> Vec<Part> {
        match self {
            Self::One(part) => vec![part],
            Self::Shaders => vec![Part::Constant, Part::Phong, Part::Mirror, Part::Glass],
            Self::All => Part::all().to_vec(),
        }
    }
}

/// Reads `PART=default`.
pub(crate) fn parse_parts(text: &str) -> Result<Parts, String> {
    let (name, value) = text.split_once('=').ok_or("a part is set back by PART=default, as in accelerator=default")?;
    if value != "default" {
        return Err(format!("`{value}`: a part can only be set to `default`, which is the reference's"));
    }
    match name {
        "all" => Ok(Parts::All),
        "shader" | "shaders" => Ok(Parts::Shaders),
        _ => Part::from_str(name, false).map(Parts::One).map_err(|_| {
            let names: Vec<String> = Part::all().iter().map(|part| part.name()).collect();
            let near = names.iter().map(|known| (strsim::damerau_levenshtein(known, name), known)).min();
            match near {
                Some((distance, known)) if distance <= 2 => {
                    format!("there is no part `{name}`: did you mean `{known}`?")
                }
                _ => format!("there is no part `{name}`: the parts are {}, and `shaders` and `all`", names.join(", ")),
            }
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_read_by_name_alone_or_together() {
        assert_eq!(parse_parts("accelerator=default"), Ok(Parts::One(Part::Accelerator)));
        assert_eq!(parse_parts("octree=default"), Ok(Parts::One(Part::Accelerator)));
        assert_eq!(parse_parts("soft-shadows=default").map(Parts::parts), Ok(vec![Part::SoftShadows]));
        assert_eq!(parse_parts("shader=default").map(|parts| parts.parts().len()), Ok(4));
        assert_eq!(parse_parts("all=default").map(Parts::parts), Ok(Part::all().to_vec()));
    }

    #[test]
    fn what_is_no_part_is_turned_down_with_what_was_meant() {
        let said = |text: &str| parse_parts(text).unwrap_err();
        assert!(said("accelrator=default").contains("did you mean `accelerator`?"));
        assert!(said("lens=default").contains("the parts are sphere, "));
        assert!(said("sphere").contains("PART=default"));
        assert!(said("sphere=naive").contains("`naive`"));
    }
}
