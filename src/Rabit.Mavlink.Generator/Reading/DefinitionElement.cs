using System;
using System.Linq;
using System.Xml;
using System.Xml.Linq;
using Rabit.Mavlink.Generator.Model;

namespace Rabit.Mavlink.Generator.Reading;

/// <summary>An XML element together with its file, so that a fault is reported where it is.</summary>
internal readonly struct DefinitionElement(XElement element, string path, FaultList faults)
{
    public XElement Element => element;

    public string Path => path;

    public string FileName => Place.FileName;

    public string? Attribute(string name) => element.Attribute(name)?.Value;

    public bool Flag(string name) => string.Equals(Attribute(name), "true", StringComparison.OrdinalIgnoreCase);

    public string? Description => Clean(element.Element("description")?.Value);

    public DefinitionMarks Marks =>
        (element.Element("wip") is null ? DefinitionMarks.None : DefinitionMarks.WorkInProgress)
        | (element.Element("deprecated") is null ? DefinitionMarks.None : DefinitionMarks.Deprecated)
        | (element.Element("superseded") is null ? DefinitionMarks.None : DefinitionMarks.Superseded);

    public string? ReplacedBy =>
        Clean((element.Element("deprecated") ?? element.Element("superseded"))?.Attribute("replaced_by")?.Value);

    public void Fault(DialectFaultKind kind, string reason) => faults.Add(kind, path, (IXmlLineInfo)element, reason);

    public void Fault(DialectFaultKind kind, XAttribute at, string reason) => faults.Add(kind, path, at, reason);

    public DefinitionPlace Place => FaultList.PlaceOf(path, element);

    public DefinitionElement Child(XElement child) => new(child, path, faults);

    /// <summary>A required attribute that must be a name. Reports and returns null where it is not.</summary>
    public string? Name(string attribute, string owner)
    {
        string? name = Attribute(attribute);
        if (name is not null && IsName(name))
            return name;
        Fault(DialectFaultKind.Malformed, name is null
            ? $"{owner} has no '{attribute}'."
            : $"{owner}: '{name}' is no name; letters, digits and underscores are allowed, with no digit in front.");
        return null;
    }

    public static string? Clean(string? text)
    {
        if (text is null)
            return null;
        string joined = string.Join(" ", text.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries));
        return joined.Length == 0 ? null : joined;
    }

    private static bool IsName(string name) =>
        name.Length != 0 && !char.IsDigit(name[0])
            && name.All(
                character => character is '_' or (>= 'a' and <= 'z') or (>= 'A' and <= 'Z') or (>= '0' and <= '9'));
}
