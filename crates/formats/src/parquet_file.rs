//! Tables as Parquet files: written and read as bytes.
//!
//! Every column is nullable, Snappy-compressed and of one of four types: DOUBLE, INT64, BOOLEAN, BYTE_ARRAY with the logical type
//! string. The units of the columns are in the file's metadata as JSON under [`UNITS`], by the name of the column; the notes of
//! the table are next to them. The same table gives the same bytes.

use std::collections::BTreeMap;
use std::sync::Arc;

use bytes::Bytes;
use parquet::basic::{Compression, LogicalType, Repetition, Type as Physical};
use parquet::column::reader::ColumnReader;
use parquet::column::writer::ColumnWriter;
use parquet::data_type::ByteArray;
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::reader::{FileReader, RowGroupReader};
use parquet::file::serialized_reader::SerializedFileReader;
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::{Type, TypePtr};

use crate::table::{ColumnKind, Heading, Table, Value};

/// Key of the units in the file's metadata.
pub const UNITS: &str = "saute.units";

/// A Parquet file that cannot be written or read.
#[derive(Debug, thiserror::Error)]
#[error("not a Parquet table of this program: {0}")]
pub struct TableError(String);

impl From<ParquetError> for TableError {
    fn from(error: ParquetError) -> Self {
        Self(error.to_string())
    }
}

impl Table {
    /// Returns the table as a Parquet file.
    ///
    /// # Errors
    /// If two columns have one name, or a row has not the columns' values.
    pub fn parquet(&self) -> Result<Vec<u8>, TableError> {
        let fields = self.headings.iter().map(field).collect::<Result<Vec<_>, _>>()?;
        let schema = Arc::new(Type::group_type_builder("saute").with_fields(fields).build()?);
        let properties = WriterProperties::builder()
            .set_compression(Compression::SNAPPY)
            .set_created_by(concat!("saute ", env!("CARGO_PKG_VERSION")).to_owned())
            .set_key_value_metadata(Some(self.metadata()));
        let mut writer = SerializedFileWriter::new(Vec::new(), schema, Arc::new(properties.build()))?;
        let mut group = writer.next_row_group()?;
        for (at, heading) in self.headings.iter().enumerate() {
            self.write_column(&mut group, at, heading)?;
        }
        group.close()?;
        Ok(writer.into_inner()?)
    }

    fn metadata(&self) -> Vec<KeyValue> {
        let units: BTreeMap<&str, &str> =
            self.headings.iter().filter(|h| !h.unit.is_empty()).map(|h| (h.name.as_str(), h.unit.as_str())).collect();
        let units = serde_json::json!(units).to_string();
        let notes = self.notes.iter().map(|(name, note)| KeyValue::new(name.clone(), note.clone()));
        notes.chain([KeyValue::new(UNITS.to_owned(), units)]).collect()
    }

    fn write_column(
        &self,
        group: &mut SerializedRowGroupWriter<'_, Vec<u8>>,
        at: usize,
        heading: &Heading,
    ) -> Result<(), TableError> {
        let cells: Vec<Option<&Value>> = self.rows.iter().map(|row| row.get(at).and_then(Option::as_ref)).collect();
        let present: Vec<i16> = cells.iter().map(|cell| i16::from(cell.is_some())).collect();
        let wrong = || TableError(format!("a value of the column {} has another type", heading.name));
        let values = || cells.iter().flatten();
        let mut column = group.next_column()?.ok_or_else(wrong)?;
        match column.untyped() {
            ColumnWriter::DoubleColumnWriter(writer) => {
                let typed = values().map(|v| if let Value::Float(v) = v { Some(*v) } else { None });
                writer.write_batch(&typed.collect::<Option<Vec<_>>>().ok_or_else(wrong)?, Some(&present), None)?;
            }
            ColumnWriter::Int64ColumnWriter(writer) => {
                let typed = values().map(|v| if let Value::Integer(v) = v { Some(*v) } else { None });
                writer.write_batch(&typed.collect::<Option<Vec<_>>>().ok_or_else(wrong)?, Some(&present), None)?;
            }
            ColumnWriter::BoolColumnWriter(writer) => {
                let typed = values().map(|v| if let Value::Flag(v) = v { Some(*v) } else { None });
                writer.write_batch(&typed.collect::<Option<Vec<_>>>().ok_or_else(wrong)?, Some(&present), None)?;
            }
            ColumnWriter::ByteArrayColumnWriter(writer) => {
                let typed =
                    values().map(|v| if let Value::Text(v) = v { Some(ByteArray::from(v.as_str())) } else { None });
                writer.write_batch(&typed.collect::<Option<Vec<_>>>().ok_or_else(wrong)?, Some(&present), None)?;
            }
            _ => return Err(wrong()),
        }
        column.close()?;
        Ok(())
    }

    /// Reads a Parquet file that this program wrote: the columns whose heading is requested.
    ///
    /// # Errors
    /// If it is damaged, or has columns of other types.
    pub fn from_parquet(bytes: Vec<u8>, wanted: impl Fn(&str) -> bool) -> Result<Self, TableError> {
        let reader = SerializedFileReader::new(Bytes::from(bytes))?;
        let file = reader.metadata().file_metadata();
        let mut notes: BTreeMap<String, String> = BTreeMap::new();
        for pair in file.key_value_metadata().into_iter().flatten() {
            notes.insert(pair.key.clone(), pair.value.clone().unwrap_or_default());
        }
        let units: BTreeMap<String, String> =
            notes.remove(UNITS).and_then(|text| serde_json::from_str(&text).ok()).unwrap_or_default();
        let columns = file.schema_descr().columns().iter().enumerate();
        let columns: Vec<(usize, String)> =
            columns.map(|(at, column)| (at, column.name().to_owned())).filter(|(_, name)| wanted(name)).collect();
        let mut table = Self { notes, ..Self::default() };
        for (at, name) in columns {
            let unit = units.get(&name).cloned().unwrap_or_default();
            let kind = kind_of(file.schema_descr().column(at).physical_type())?;
            table.headings.push(Heading { name, unit, kind });
            let mut cells = Vec::new();
            for group in 0..reader.num_row_groups() {
                read_column(reader.get_row_group(group)?.as_ref(), at, &mut cells)?;
            }
            table.rows.resize_with(cells.len(), Vec::new);
            table.rows.iter_mut().zip(cells).for_each(|(row, cell)| row.push(cell));
        }
        Ok(table)
    }

    /// Returns the number of rows of a Parquet file.
    ///
    /// # Errors
    /// If it is damaged or cut off.
    pub fn rows_in_parquet(bytes: Vec<u8>) -> Result<u64, TableError> {
        let reader = SerializedFileReader::new(Bytes::from(bytes))?;
        Ok(reader.metadata().file_metadata().num_rows().unsigned_abs())
    }
}

fn field(heading: &Heading) -> Result<TypePtr, ParquetError> {
    let (physical, logical) = match heading.kind {
        ColumnKind::Float => (Physical::DOUBLE, None),
        ColumnKind::Integer => (Physical::INT64, None),
        ColumnKind::Flag => (Physical::BOOLEAN, None),
        ColumnKind::Text => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
    };
    let builder = Type::primitive_type_builder(&heading.name, physical);
    builder.with_repetition(Repetition::OPTIONAL).with_logical_type(logical).build().map(Arc::new)
}

fn kind_of(physical: Physical) -> Result<ColumnKind, TableError> {
    match physical {
        Physical::DOUBLE => Ok(ColumnKind::Float),
        Physical::INT64 => Ok(ColumnKind::Integer),
        Physical::BOOLEAN => Ok(ColumnKind::Flag),
        Physical::BYTE_ARRAY => Ok(ColumnKind::Text),
        other => Err(TableError(format!("a column has the type {other}"))),
    }
}

/// Appends the cells of a column of one row group.
fn read_column(group: &dyn RowGroupReader, at: usize, cells: &mut Vec<Option<Value>>) -> Result<(), TableError> {
    let rows = group.metadata().num_rows().unsigned_abs() as usize;
    let mut present = Vec::new();
    let values: Vec<Value> = match group.get_column_reader(at)? {
        ColumnReader::DoubleColumnReader(mut reader) => {
            let mut values = Vec::new();
            reader.read_records(rows, Some(&mut present), None, &mut values)?;
            values.into_iter().map(Value::Float).collect()
        }
        ColumnReader::Int64ColumnReader(mut reader) => {
            let mut values = Vec::new();
            reader.read_records(rows, Some(&mut present), None, &mut values)?;
            values.into_iter().map(Value::Integer).collect()
        }
        ColumnReader::BoolColumnReader(mut reader) => {
            let mut values = Vec::new();
            reader.read_records(rows, Some(&mut present), None, &mut values)?;
            values.into_iter().map(Value::Flag).collect()
        }
        ColumnReader::ByteArrayColumnReader(mut reader) => {
            let mut values = Vec::new();
            reader.read_records(rows, Some(&mut present), None, &mut values)?;
            let text = |bytes: ByteArray| Value::Text(String::from_utf8_lossy(bytes.data()).into_owned());
            values.into_iter().map(text).collect()
        }
        _ => return Err(TableError("a column has an unknown type".to_owned())),
    };
    let mut values = values.into_iter();
    cells.extend(present.iter().map(|level| if *level > 0 { values.next() } else { None }));
    Ok(())
}
