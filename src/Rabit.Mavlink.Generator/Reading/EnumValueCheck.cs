using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink.Generator.Model;

namespace Rabit.Mavlink.Generator.Reading;

/// <summary>
/// Checks the values of enums against the fields that carry them. What no field can send is an error. A field that is
/// too narrow for some of the values is a warning, since its messages may never use these; it is none where another
/// field of the same message takes them, as GIMBAL_DEVICE_INFORMATION has a second one for later flags. The parameters
/// of commands are floats and carry all.
/// </summary>
internal sealed class EnumValueCheck(EnumReader enums, IReadOnlyList<EnumUse> uses, FaultList faults)
{
    public void Run()
    {
        IReadOnlyList<EnumDefinition> definitions = enums.Enums;
        HashSet<string> ofParameters = new(
            definitions.SelectMany(definition => definition.Entries).SelectMany(entry => entry.Parameters)
                .Select(parameter => parameter.Enum).Where(name => name is not null)!, StringComparer.Ordinal);
        ILookup<string, EnumUse> usesByEnum = uses.ToLookup(use => use.Field.Enum!, StringComparer.Ordinal);
        foreach (EnumDefinition definition in definitions)
        {
            CheckBits(definition);
            CheckValues(
                definition,
                usesByEnum[definition.Name].Where(use => use.Field.Type.IsInteger).ToList(),
                ofParameters.Contains(definition.Name));
        }

        foreach (EnumUse use in uses.Where(use => !use.Field.Type.IsInteger))
        {
            use.Element.Fault(
                DialectFaultKind.EnumOfFloat,
                $"Field {use.Field.Name} of message {use.Message.Name} is a {use.Field.Type.Name}, "
                + $"so it gets no type of enum {use.Field.Enum}; use an integer type.");
        }
    }

    private void CheckValues(EnumDefinition definition, List<EnumUse> integers, bool isOfParameters)
    {
        HashSet<EnumEntry> unsendable = [];
        if (integers.Count != 0 && !isOfParameters)
            unsendable = [.. definition.Entries.Where(entry => !integers.Any(use => Fits(entry, use.Field)))];
        foreach (EnumEntry entry in unsendable)
            ReportEntry(definition, entry, integers);
        foreach (EnumUse use in integers)
            CheckField(use, definition.Entries.Where(entry => !unsendable.Contains(entry)).ToList());
    }

    private static bool Fits(EnumEntry entry, FieldDefinition field) =>
        entry.Value >= field.Type.Min && entry.Value <= field.Type.Max;

    private static void CheckField(EnumUse use, List<EnumEntry> entries)
    {
        List<FieldDefinition> carriers = use.Message.Fields
            .Where(field => field.Type.IsInteger && string.Equals(field.Enum, use.Field.Enum, StringComparison.Ordinal))
            .ToList();
        List<EnumEntry> tooLarge = entries.Where(entry => !carriers.Any(field => Fits(entry, field))).ToList();
        if (tooLarge.Count == 0)
            return;
        string others = tooLarge.Count == 1 ? "" : $" and {tooLarge.Count - 1} more";
        use.Element.Fault(
            DialectFaultKind.FieldTooNarrow,
            $"Field {use.Field.Name} of message {use.Message.Name} is of type {use.Field.Type.Name}, "
            + $"which cannot carry {tooLarge[0].Name} = {tooLarge[0].Value}{others} of enum {use.Field.Enum}.");
    }

    private void ReportEntry(EnumDefinition definition, EnumEntry entry, List<EnumUse> uses)
    {
        EnumUse widest = uses.OrderByDescending(use => use.Field.Type.Size).First();
        faults.Add(
            DialectFaultKind.ValueFitsNoField, entry.Place!,
            $"{entry.Name} of enum {definition.Name} is {entry.Value}, which no field of that enum can carry: "
            + $"{widest.Field.Name} of message {widest.Message.Name} is of type {widest.Field.Type.Name}.");
    }

    // Two or more bits in one entry are a name for a combination, which upstream has too. A bit that has no name by
    // itself is probably a mistake.
    private void CheckBits(EnumDefinition definition)
    {
        if (!definition.IsBitmask)
            return;
        ulong named = 0;
        foreach (ulong value in definition.Entries.Select(Bits).Where(value => (value & (value - 1)) == 0))
            named |= value;
        foreach (EnumEntry entry in definition.Entries.Where(entry => (Bits(entry) & ~named) != 0))
        {
            faults.Add(
                DialectFaultKind.UnnamedBits, entry.Place!,
                $"{entry.Name} of bit mask {definition.Name} is {entry.Value}: "
                + "a combination with bits that no entry names by itself. Bits are 1, 2, 4, 8 and so on.");
        }
    }

    private static ulong Bits(EnumEntry entry) =>
        entry.Value < 0 ? unchecked((ulong)(long)entry.Value) : (ulong)entry.Value;
}
