//! One array of a VTU file: its element, and its numbers as base64 text, in blocks where they are compressed.

use base64_simd::STANDARD as BASE64;
use miniz_oxide::deflate::compress_to_vec_zlib;
use quick_xml::events::{BytesText, Event};
use quick_xml::{Error as Xml, Writer};

use super::Compression;

/// Bytes of a block before it is compressed: VTK's own default.
const BLOCK: usize = 32_768;

/// Level of zlib: files of one part in twenty less cost twice the time.
const ZLIB_LEVEL: u8 = 6;

/// ArrayNumbers of an array.
#[derive(Debug, Clone, Copy)]
pub(super) enum ArrayNumbers<'a> {
    Float64(&'a [f64]),
    /// Written with 32 bits each.
    Float32(&'a [f64]),
    UInt32(&'a [u32]),
    UInt8(&'a [u8]),
}

impl ArrayNumbers<'_> {
    /// VTK's name of the type.
    fn kind(self) -> &'static str {
        match self {
            Self::Float64(_) => "Float64",
            Self::Float32(_) => "Float32",
            Self::UInt32(_) => "UInt32",
            Self::UInt8(_) => "UInt8",
        }
    }

    /// The bytes after these first ones, as they are in memory.
    fn bytes(self, mut first: Vec<u8>) -> Vec<u8> {
        first.reserve_exact(self.size());
        match self {
            Self::Float64(numbers) => first.extend_from_slice(bytemuck::cast_slice(numbers)),
            Self::Float32(numbers) => first.extend(numbers.iter().flat_map(|&x| (x as f32).to_ne_bytes())),
            Self::UInt32(numbers) => first.extend_from_slice(bytemuck::cast_slice(numbers)),
            Self::UInt8(numbers) => first.extend_from_slice(numbers),
        }
        first
    }

    /// Number of bytes.
    fn size(self) -> usize {
        match self {
            Self::Float64(numbers) => 8 * numbers.len(),
            Self::Float32(numbers) => 4 * numbers.len(),
            Self::UInt32(numbers) => 4 * numbers.len(),
            Self::UInt8(numbers) => numbers.len(),
        }
    }
}

/// One array: so many numbers a row, and their unit if they have one.
#[derive(Debug, Clone, Copy)]
pub(super) struct Array<'a> {
    pub(super) name: &'a str,
    pub(super) unit: Option<&'a str>,
    pub(super) components: usize,
    pub(super) numbers: ArrayNumbers<'a>,
}

impl<'a> Array<'a> {
    /// An array without a unit.
    pub(super) fn plain(name: &'a str, components: usize, numbers: ArrayNumbers<'a>) -> Self {
        Self { name, unit: None, components, numbers }
    }

    /// The numbers of the array as text: the number of bytes and the bytes in one, or the sizes of the compressed
    /// blocks before the blocks.
    pub(super) fn text(&self, compression: Compression) -> String {
        let encoder: fn(&[u8]) -> Vec<u8> = match compression {
            Compression::None => {
                let size = (self.numbers.size() as u64).to_ne_bytes();
                return BASE64.encode_to_string(self.numbers.bytes(size.to_vec()));
            }
            Compression::Lz4 => lz4_flex::block::compress,
            Compression::Zlib => |block| compress_to_vec_zlib(block, ZLIB_LEVEL),
        };
        let bytes = self.numbers.bytes(Vec::new());
        let blocks: Vec<_> = bytes.chunks(BLOCK).map(encoder).collect();
        // The size of the last block also where it is whole: VTK takes zero for that too, vtkio does not.
        let last = bytes.chunks(BLOCK).last().map_or(0, <[u8]>::len);
        let sizes = [blocks.len(), BLOCK, last];
        let sizes = sizes.into_iter().chain(blocks.iter().map(Vec::len));
        let header: Vec<u8> = sizes.flat_map(|size| (size as u64).to_ne_bytes()).collect();
        BASE64.encode_to_string(header) + &BASE64.encode_to_string(blocks.concat())
    }

    /// Writes its element with this text.
    pub(super) fn write(&self, file: &mut Writer<Vec<u8>>, text: String) -> Result<(), Xml> {
        let components = self.components.to_string();
        let components = (self.components > 1).then_some(("NumberOfComponents", components.as_str()));
        let kind = [("type", self.numbers.kind()), ("Name", self.name)];
        let form = [("format", "binary")];
        file.create_element("DataArray")
            .with_attributes(kind.into_iter().chain(components).chain(form))
            .write_inner_content(|file| {
                file.write_event(Event::Text(BytesText::from_escaped(text)))?;
                if let Some(unit) = self.unit {
                    file.create_element("InformationKey")
                        .with_attributes([("name", "UNITS_LABEL"), ("location", "vtkDataArray")])
                        .write_text_content(BytesText::new(unit))?;
                }
                Ok::<(), Xml>(())
            })?;
        Ok(())
    }
}
