using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Xml;

namespace Rabit.Mavlink.Generator.Reading;

/// <summary>
/// Finds the definition files that stand for a dialect of their own: those that none of the others includes.
/// </summary>
public static class DialectRoots
{
    /// <summary>
    /// Finds the roots. Broken files are no reason to fail: reading them as definitions reports what is wrong.
    /// </summary>
    /// <param name="files">The files of a project.</param>
    /// <returns>
    /// The roots, in the order of the files. Where all files include each other in a cycle, the first: reading it shows
    /// the cycle.
    /// </returns>
    public static IReadOnlyList<DialectFile> Of(IReadOnlyList<DialectFile> files)
    {
        if (files is null)
            throw new ArgumentNullException(nameof(files));
        var reached = new HashSet<DialectFile>();
        var roots = new List<DialectFile>();
        Dictionary<DialectFile, List<DialectFile>> includes = files.Distinct()
            .ToDictionary(file => file, file => IncludesOf(file, files));
        HashSet<DialectFile> included =
            [.. includes.SelectMany(pair => pair.Value.Where(target => target != pair.Key))];
        foreach (DialectFile file in includes.Keys.OrderBy(file => included.Contains(file)))
        {
            // After those that no file includes only cycles are left that no root leads to: each gives its first file.
            if (!reached.Contains(file))
            {
                roots.Add(file);
                Reach(file, includes, reached);
            }
        }

        return roots;
    }

    private static void Reach(
        DialectFile file, Dictionary<DialectFile, List<DialectFile>> includes, HashSet<DialectFile> reached)
    {
        if (!reached.Add(file))
            return;
        foreach (DialectFile target in includes[file])
            Reach(target, includes, reached);
    }

    private static List<DialectFile> IncludesOf(DialectFile file, IReadOnlyList<DialectFile> files)
    {
        var includes = new List<DialectFile>();
        try
        {
            using var reader = XmlReader.Create(
                new StringReader(file.Text), new XmlReaderSettings { DtdProcessing = DtdProcessing.Prohibit });
            bool isInclude = false;
            while (reader.Read())
            {
                if (isInclude && reader.NodeType is (XmlNodeType.Text or XmlNodeType.CDATA)
                    && IncludePath.Find(files, file.Path, reader.Value.Trim()) is { } target)
                    includes.Add(target);
                isInclude = reader.NodeType == XmlNodeType.Element && reader.LocalName == "include";
            }
        }
        catch (XmlException)
        {
            // What was read up to there counts; the fault is reported when the file is read as a definition.
        }

        return includes;
    }
}
