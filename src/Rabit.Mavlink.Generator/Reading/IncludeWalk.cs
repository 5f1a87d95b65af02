using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Xml;
using System.Xml.Linq;

namespace Rabit.Mavlink.Generator.Reading;

/// <summary>Follows includes from a root file and lists every file once, included ones first.</summary>
internal sealed class IncludeWalk(IReadOnlyList<DialectFile> files, FaultList faults)
{
    private readonly List<DefinitionElement> _roots = [];
    private readonly HashSet<string> _done = new(StringComparer.OrdinalIgnoreCase);
    private readonly List<string> _open = [];

    public IReadOnlyList<DefinitionElement> Walk(DialectFile root)
    {
        Visit(root);
        return _roots;
    }

    private void Visit(DialectFile file)
    {
        if (!_done.Add(IncludePath.Normalize(file.Path)) || Load(file) is not { } root)
            return;
        _open.Add(file.Path);
        foreach (XElement include in root.Elements("include"))
            Follow(file, new DefinitionElement(include, file.Path, faults));
        _open.RemoveAt(_open.Count - 1);
        _roots.Add(new DefinitionElement(root, file.Path, faults));
    }

    private void Follow(DialectFile from, DefinitionElement include)
    {
        string name = include.Element.Value.Trim();
        if (IncludePath.Find(files, from.Path, name) is not { } target)
        {
            include.Fault(DialectFaultKind.MissingInclude, $"'{name}' is included but was not found among the definition files.");
            return;
        }

        int first = _open.FindIndex(path => IncludePath.Same(path, target.Path));
        if (first >= 0)
        {
            IEnumerable<string> cycle = _open.Skip(first).Append(target.Path).Select(IncludePath.FileName);
            include.Fault(DialectFaultKind.IncludeCycle, $"'{name}' includes itself: {string.Join(" -> ", cycle)}.");
            return;
        }

        Visit(target);
    }

    private XElement? Load(DialectFile file)
    {
        try
        {
            // No document types: a definition needs none, and a few lines of them can expand to gigabytes.
            using var reader = XmlReader.Create(new StringReader(file.Text), new XmlReaderSettings { DtdProcessing = DtdProcessing.Prohibit });
            XElement? root = XDocument.Load(reader, LoadOptions.SetLineInfo).Root;
            if (root?.Name.LocalName == "mavlink")
                return root;
            faults.Add(DialectFaultKind.Malformed, file.Path, root, $"The root element is '{root?.Name.LocalName}', a MAVLink definition has 'mavlink'.");
        }
        catch (XmlException exception)
        {
            faults.Add(file.Path, exception);
        }

        return null;
    }
}
