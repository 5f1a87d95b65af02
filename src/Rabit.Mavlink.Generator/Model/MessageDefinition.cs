using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Mavlink.Generator.Model;

/// <summary>One message, with what follows from its fields: wire order, offsets, lengths and checksum byte.</summary>
public sealed class MessageDefinition
{
    private readonly Dictionary<FieldDefinition, int> _offsets = [];

    /// <summary>Puts the fields in wire order and computes what follows from it.</summary>
    /// <param name="id">Message id.</param>
    /// <param name="name">Name in the definition.</param>
    /// <param name="fields">Fields in the order of the definition.</param>
    public MessageDefinition(int id, string name, IReadOnlyList<FieldDefinition> fields)
    {
        Id = id;
        Name = name;
        Fields = fields;
        // OrderBy is stable, which the wire order relies on (MAVLink guide, "Field reordering").
        List<FieldDefinition> basic = fields.Where(field => !field.IsExtension)
            .OrderByDescending(field => field.Type.Size).ToList();
        MinLength = basic.Sum(field => field.WireLength);
        CrcExtra = Model.CrcExtra.Compute(name, basic);
        WireFields = basic.Concat(fields.Where(field => field.IsExtension)).ToList();
        foreach (FieldDefinition field in WireFields)
        {
            _offsets[field] = MaxLength;
            MaxLength += field.WireLength;
        }
    }

    /// <summary>Message id, 0 to 16 777 215.</summary>
    public int Id { get; }

    /// <summary>Name in the definition.</summary>
    public string Name { get; }

    /// <summary>Fields in the order of the definition.</summary>
    public IReadOnlyList<FieldDefinition> Fields { get; }

    /// <summary>
    /// Fields in the order of the wire: large elements first, extensions last in the order of the definition.
    /// </summary>
    public IReadOnlyList<FieldDefinition> WireFields { get; }

    /// <summary>Payload bytes without extensions.</summary>
    public int MinLength { get; }

    /// <summary>Payload bytes with extensions.</summary>
    public int MaxLength { get; }

    /// <summary>The byte that ends the checksum.</summary>
    public byte CrcExtra { get; }

    /// <summary>Name of the file that defines it, without folder.</summary>
    public string File { get; init; } = "";

    /// <summary>The definition's own words.</summary>
    public string? Description { get; init; }

    /// <summary>Its age.</summary>
    public DefinitionMarks Marks { get; init; }

    /// <summary>
    /// What to use instead of a deprecated or superseded one; null where the definition names nothing.
    /// </summary>
    public string? ReplacedBy { get; init; }

    /// <summary>Where a field begins in the payload.</summary>
    /// <param name="field">One of <see cref="Fields"/>.</param>
    /// <returns>Bytes from the start of the payload.</returns>
    public int OffsetOf(FieldDefinition field) => _offsets[field];

    /// <summary>Where the byte of an address field is.</summary>
    /// <param name="fieldName"><c>target_system</c> or <c>target_component</c>.</param>
    /// <returns>Bytes from the start of the payload, or -1 where the message has no such single byte.</returns>
    public int AddressOffset(string fieldName)
    {
        FieldDefinition? field = Fields.FirstOrDefault(candidate =>
            candidate.ArrayLength == 0 && candidate.Type.Size == 1
                && string.Equals(candidate.Name, fieldName, StringComparison.Ordinal));
        return field is null ? -1 : OffsetOf(field);
    }

    /// <summary>
    /// Whether another definition means the same bytes: id, name and every field by name, type, length and place.
    /// </summary>
    /// <param name="other">The other definition.</param>
    /// <returns>Whether one struct will do for both. Units, enums and words may differ.</returns>
    public bool HasSameWireForm(MessageDefinition other) =>
        other is not null && Id == other.Id && string.Equals(Name, other.Name, StringComparison.Ordinal)
        && Fields.Count == other.Fields.Count
        && Fields.Zip(other.Fields, (left, right) =>
            string.Equals(left.Name, right.Name, StringComparison.Ordinal) && left.Type == right.Type
            && left.ArrayLength == right.ArrayLength && left.IsExtension == right.IsExtension).All(isSame => isSame);
}
