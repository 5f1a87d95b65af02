using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Xml;
using System.Xml.Linq;
using Rabit.Mavlink.Generator.Model;

namespace Rabit.Mavlink.Generator.Reading;

/// <summary>Follows includes from a root file and lists every file once, included ones first.</summary>
internal sealed class IncludeWalk(IReadOnlyList<DialectFile> files, FaultList faults)
{
    private readonly List<DefinitionElement> _roots = [];
    private readonly HashSet<string> _done = new(StringComparer.OrdinalIgnoreCase);
    private readonly List<string> _open = [];
    private readonly Dictionary<string, SortedSet<string>> _parts = new(StringComparer.OrdinalIgnoreCase);

    /// <summary>The files found, included ones first.</summary>
    public IReadOnlyList<DialectPart> Parts
        => _roots.Select(root => new DialectPart(root.FileName, _parts[IncludePath.Normalize(root.Path)])).ToList();

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
        _parts[IncludePath.Normalize(file.Path)] = new SortedSet<string>(StringComparer.Ordinal)
        {
            IncludePath.FileName(file.Path)
        };
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
            include.Fault(DialectFaultKind.MissingInclude, $"'{name}' is included, but it is neither among the "
                + "definition files of the project nor among those of the package.");
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
        if (_parts.TryGetValue(IncludePath.Normalize(target.Path), out SortedSet<string>? included))
            _parts[IncludePath.Normalize(from.Path)].UnionWith(included);
    }

    private XElement? Load(DialectFile file)
    {
        try
        {
            // No document types: a definition needs none, and a few lines of them can expand to gigabytes.
            using var reader = XmlReader.Create(
                new StringReader(file.Text), new XmlReaderSettings { DtdProcessing = DtdProcessing.Prohibit });
            XElement? root = XDocument.Load(reader, LoadOptions.SetLineInfo).Root;
            if (root?.Name.LocalName == "mavlink")
                return root;
            faults.Add(
                DialectFaultKind.Malformed, file.Path, root,
                $"The root element is '{root?.Name.LocalName}', a MAVLink definition has 'mavlink'.");
        }
        catch (XmlException exception)
        {
            faults.Add(file.Path, exception);
        }

        return null;
    }
}
