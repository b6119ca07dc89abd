//! The files of the page, as the build left them.

use std::io::{self, Read as _};

use flate2::read::GzDecoder;

/// One file.
pub(super) struct File {
    /// as a browser asks for it, with a slash before it
    pub(super) path: &'static str,
    /// its media type
    pub(super) media: &'static str,
    /// changes when the file does
    pub(super) tag: &'static str,
    /// bytes when it is not compressed
    length: usize,
    pub(super) gzip: &'static [u8],
}

include!(concat!(env!("OUT_DIR"), "/page.rs"));

impl File {
    /// The file at an address, byte for byte: there are no folders to climb out of.
    pub(super) fn at(path: &str) -> Option<&'static Self> {
        let path = if path == "/" { "/index.html" } else { path };
        FILES.iter().find(|file| file.path == path)
    }

    /// For a client that does not decompress.
    pub(super) fn plain(&self) -> io::Result<Vec<u8>> {
        let mut plain = Vec::with_capacity(self.length);
        GzDecoder::new(self.gzip).read_to_end(&mut plain)?;
        Ok(plain)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_file_comes_out_as_long_as_it_went_in() {
        assert!(File::at("/").is_some());
        for file in FILES {
            assert_eq!(file.plain().unwrap().len(), file.length, "{}", file.path);
        }
    }
}
