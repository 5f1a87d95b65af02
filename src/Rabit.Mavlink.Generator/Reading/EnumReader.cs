using System;
using System.Collections.Generic;
using System.Linq;
using System.Xml.Linq;
using Rabit.Mavlink.Generator.Model;

namespace Rabit.Mavlink.Generator.Reading;

/// <summary>Collects enums; the entries that several files give to one enum are merged.</summary>
internal sealed class EnumReader
{
    private readonly Dictionary<string, MergedEnum> _enums = new(StringComparer.Ordinal);

    public bool Knows(string name) => _enums.ContainsKey(name);

    public IReadOnlyList<EnumDefinition> Enums =>
        _enums.Values.Select(merged => merged.ToDefinition())
            .OrderBy(definition => definition.Name, StringComparer.Ordinal).ToList();

    public void Read(DefinitionElement element)
    {
        if (element.Name("name", "An enum") is not { } name)
            return;
        if (!_enums.TryGetValue(name, out MergedEnum? merged))
            _enums.Add(name, merged = new MergedEnum(name));
        merged.IsBitmask |= element.Flag("bitmask");
        merged.Description ??= element.Description;
        merged.Marks |= element.Marks;
        foreach (XElement entry in element.Element.Elements("entry"))
            ReadEntry(merged, element.Child(entry));
    }

    private static void ReadEntry(MergedEnum merged, DefinitionElement element)
    {
        if (element.Name("name", $"An entry of enum {merged.Name}") is not { } name)
            return;
        string? text = element.Attribute("value");
        decimal value = merged.NextValue;
        if (text is null ? !NumberText.Fits(value) : !NumberText.TryParse(text, out value))
        {
            element.Fault(DialectFaultKind.MalformedNumber, $"Value '{text ?? "one more"}' of {name} in enum "
                + $"{merged.Name} is no number of 64 bits; write 12, 0x1F, 0b101 or 2**4.");
            return;
        }

        if (merged.TryAdd(ToEntry(name, value, element)) is not { } other)
            return;
        if (string.Equals(other.Name, name, StringComparison.Ordinal))
        {
            element.Fault(
                DialectFaultKind.ConflictingEnumValue,
                $"{name} of enum {merged.Name} is {value} here and {other.Value} elsewhere.");
        }
        else
        {
            element.Fault(
                DialectFaultKind.DuplicateEnumValue,
                $"{name} of enum {merged.Name} is {value}, which is {other.Name} in {other.Place!.FileName} already.");
        }
    }

    private static EnumEntry ToEntry(string name, decimal value, DefinitionElement element) => new(name, value)
    {
        Description = element.Description,
        Place = element.Place,
        Marks = element.Marks,
        ReplacedBy = element.ReplacedBy,
        Parameters = element.Element.Elements("param").Select(ToParameter).Where(
            parameter => parameter is not null).ToList()!,
    };

    // A parameter only feeds the docs, so a bad one is left out rather than reported.
    private static CommandParameter? ToParameter(XElement element) =>
        NumberText.TryParse(element.Attribute("index")?.Value ?? "", out decimal index) && index is >= 1 and <= 7
            ? new CommandParameter((int)index)
            {
                Label = element.Attribute("label")?.Value,
                Units = element.Attribute("units")?.Value,
                Enum = element.Attribute("enum")?.Value,
                MinValue = element.Attribute("minValue")?.Value,
                MaxValue = element.Attribute("maxValue")?.Value,
                Description = DefinitionElement.Clean(element.Value),
            }
            : null;
}
