//! Walks over the numbers of one section, in text and in binary alike.

use crate::Error;
use crate::error::FilePosition;

/// What most words of a text are.
const WHOLE: &str = "a whole number";

/// Most nodes or elements of a mesh: numbers of nodes, edges and sides of triangles have 32 bits.
const MOST: u64 = 1 << 30;

/// A reading position in one section of a file.
pub(super) struct Cursor<'a> {
    bytes: &'a [u8],
    at: usize,
    binary: bool,
    section: &'static str,
}

impl<'a> Cursor<'a> {
    pub(super) fn new(bytes: &'a [u8], at: usize, binary: bool, section: &'static str) -> Self {
        Self { bytes, at, binary, section }
    }

    pub(super) fn is_binary(&self) -> bool {
        self.binary
    }

    pub(super) fn position(&self) -> FilePosition {
        position(self.bytes, self.at, self.binary)
    }

    pub(super) fn damaged(&self, what: impl Into<String>) -> Error {
        Error::Damaged { section: self.section.to_owned(), position: self.position(), what: what.into() }
    }

    /// The next unsigned number (gmsh: `size_t`).
    pub(super) fn size(&mut self) -> Result<u64, Error> {
        if self.binary {
            let value = self.bytes.get(self.at..).and_then(|rest| rest.first_chunk::<8>());
            let value = value.ok_or_else(|| self.damaged("the section breaks off"))?;
            self.at += 8;
            return Ok(u64::from_le_bytes(*value));
        }
        let token = self.token()?;
        let mut value = 0u64;
        for &byte in token {
            let digit = byte.wrapping_sub(b'0');
            let grown = value.checked_mul(10).and_then(|tens| tens.checked_add(u64::from(digit)));
            match grown {
                Some(grown) if digit < 10 => value = grown,
                _ => return Err(self.not_a_number(token, WHOLE)),
            }
        }
        Ok(value)
    }

    /// The next signed number (gmsh: `int`).
    pub(super) fn int(&mut self) -> Result<i32, Error> {
        if self.binary {
            let value = self.bytes.get(self.at..).and_then(|rest| rest.first_chunk::<4>());
            let value = value.ok_or_else(|| self.damaged("the section breaks off"))?;
            self.at += 4;
            return Ok(i32::from_le_bytes(*value));
        }
        let token = self.token()?;
        let value = std::str::from_utf8(token).ok().and_then(|text| text.parse().ok());
        value.ok_or_else(|| self.not_a_number(token, WHOLE))
    }

    /// The next number, a count of things of at least `values` numbers each: refused if the rest
    /// of the file cannot hold them, so that nothing is allocated on the word of a damaged file.
    pub(super) fn count(&mut self, values: usize, what: &str) -> Result<usize, Error> {
        let count = self.size()?;
        let room = (self.bytes.len() - self.at) / (if self.binary { 8 } else { 2 } * values.max(1));
        // A text may end without a line break after its last number.
        let room = room as u64 + u64::from(!self.binary);
        if count > room.min(MOST) {
            return Err(
                self.damaged(format!("{count} {what} announced, but there is room for {} at most", room.min(MOST)))
            );
        }
        Ok(count as usize)
    }

    /// Appends `count` unsigned numbers to `values`.
    pub(super) fn sizes(&mut self, count: usize, values: &mut Vec<u64>) -> Result<(), Error> {
        if self.binary {
            let start = self.at;
            self.skip(count)?;
            let (words, _) = self.bytes[start..self.at].as_chunks::<8>();
            values.extend(words.iter().map(|&word| u64::from_le_bytes(word)));
            return Ok(());
        }
        for _ in 0..count {
            values.push(self.size()?);
        }
        Ok(())
    }

    /// Appends `count` points `(x, y, z)` to `values`, and passes over `own` more numbers behind each.
    pub(super) fn points(&mut self, count: usize, own: usize, values: &mut Vec<[f64; 3]>) -> Result<(), Error> {
        if self.binary {
            let start = self.at;
            self.skip((3 + own) * count)?;
            let (words, _) = self.bytes[start..self.at].as_chunks::<8>();
            let coordinates = |point: &[[u8; 8]]| [0, 1, 2].map(|k| f64::from_le_bytes(point[k]));
            values.extend(words.chunks_exact(3 + own).map(coordinates));
            return Ok(());
        }
        for _ in 0..count {
            let axes = ["the x coordinate", "the y coordinate", "the z coordinate"];
            let [x, y, z] = axes.map(|wanted| self.real(wanted));
            values.push([x?, y?, z?]);
            self.skip(own)?;
        }
        Ok(())
    }

    /// The next number of a text, called `wanted` if it is none.
    fn real(&mut self, wanted: &str) -> Result<f64, Error> {
        let token = self.token()?;
        let value = std::str::from_utf8(token).ok().and_then(|text| text.parse().ok());
        value.ok_or_else(|| self.not_a_number(token, wanted))
    }

    /// A count and as many signed numbers.
    pub(super) fn ints(&mut self, what: &str) -> Result<Vec<i32>, Error> {
        let count = self.count(1, what)?;
        (0..count).map(|_| self.int()).collect()
    }

    /// Passes over `count` numbers of eight bytes, or as many words of text.
    pub(super) fn skip(&mut self, count: usize) -> Result<(), Error> {
        if self.binary {
            let end = count.checked_mul(8).and_then(|length| self.at.checked_add(length));
            match end.filter(|&end| end <= self.bytes.len()) {
                Some(end) => self.at = end,
                None => return Err(self.damaged("the section breaks off")),
            }
            return Ok(());
        }
        for _ in 0..count {
            self.token()?;
        }
        Ok(())
    }

    /// Expects the closing line of the section and returns the offset after it.
    pub(super) fn close(&mut self) -> Result<usize, Error> {
        self.skip_space();
        let rest = &self.bytes[self.at..];
        let closed = rest
            .strip_prefix(b"$End")
            .and_then(|rest| rest.strip_prefix(self.section.as_bytes()))
            .filter(|rest| rest.first().is_none_or(u8::is_ascii_whitespace));
        match closed {
            Some(after) => Ok(self.bytes.len() - after.len()),
            None => Err(self.damaged(format!("\"$End{}\" should follow here", self.section))),
        }
    }

    fn skip_space(&mut self) {
        let rest = &self.bytes[self.at..];
        self.at += rest.iter().position(|byte| !byte.is_ascii_whitespace()).unwrap_or(rest.len());
    }

    /// The next word of a text; the `$` of a closing line ends the section.
    fn token(&mut self) -> Result<&'a [u8], Error> {
        self.skip_space();
        let rest = &self.bytes[self.at..];
        let length = rest.iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len());
        if length == 0 || rest[0] == b'$' {
            return Err(self.damaged("the section breaks off, more numbers were announced"));
        }
        self.at += length;
        Ok(&rest[..length])
    }

    fn not_a_number(&self, token: &[u8], wanted: &str) -> Error {
        let shown = String::from_utf8_lossy(&token[..token.len().min(24)]).into_owned();
        self.damaged(format!("\"{shown}\" where {wanted} should be"))
    }
}

/// Line (text) or byte (binary) of an offset.
pub(super) fn position(bytes: &[u8], offset: usize, binary: bool) -> FilePosition {
    if binary {
        return FilePosition::Byte(offset);
    }
    let before = &bytes[..offset.min(bytes.len())];
    FilePosition::Line(1 + before.iter().filter(|&&byte| byte == b'\n').count())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_and_binary_numbers() {
        let mut text = Cursor::new(b" 12\r\n-3 4.5 x $EndNodes\n", 0, false, "Nodes");
        assert_eq!((text.size().unwrap(), text.int().unwrap()), (12, -3));
        text.skip(2).unwrap();
        assert_eq!(text.close().unwrap(), 23);
        assert!(text.size().is_err());
        let mut binary = Cursor::new(b"\x02\0\0\0\0\0\0\0\xff\xff\xff\xff", 0, true, "Nodes");
        assert_eq!((binary.size().unwrap(), binary.int().unwrap()), (2, -1));
        assert!(binary.int().is_err());
    }

    #[test]
    fn points_with_coordinates_of_their_own() {
        let numbers = [1.0, 2.0, 3.0, 0.5, 0.25, 4.0, 5.0, 6.0, 0.5, 0.75];
        let bytes: Vec<u8> = numbers.iter().flat_map(|number: &f64| number.to_le_bytes()).collect();
        for (bytes, binary) in [(bytes, true), (b"1 2 3 .5 .25 4 5 6 .5 .75".to_vec(), false)] {
            let mut points = Vec::new();
            let mut cursor = Cursor::new(&bytes, 0, binary, "Nodes");
            cursor.points(2, 2, &mut points).unwrap();
            assert_eq!(points, [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]);
            assert!(cursor.points(1, 0, &mut points).is_err());
        }
    }

    #[test]
    fn counts_beyond_the_file_are_refused() {
        for count in ["4", "1000000000000000000", "99999999999999999999", "-1", "1e3"] {
            let text = format!("{count} 1 2 3");
            assert!(Cursor::new(text.as_bytes(), 0, false, "Nodes").count(2, "nodes").is_err());
        }
        assert_eq!(Cursor::new(b"3 1 2 3", 0, false, "Nodes").count(1, "nodes").unwrap(), 3);
    }
}
