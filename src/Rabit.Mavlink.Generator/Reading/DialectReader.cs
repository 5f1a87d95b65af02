using System;
using System.Collections.Generic;
using System.IO;
using System.Xml.Linq;
using Rabit.Mavlink.Generator.Model;

namespace Rabit.Mavlink.Generator.Reading;

/// <summary>Reads MAVLink definitions (MAVLink guide, "MAVLink XML schema") with everything they include.</summary>
public static class DialectReader
{
    /// <summary>
    /// Reads a root file and what it includes. Throws for no definition, however broken: what is wrong is in the
    /// result.
    /// </summary>
    /// <param name="root">The file to begin with.</param>
    /// <param name="files">All files that may be included; the root may be among them.</param>
    /// <returns>The valid definitions and the faults.</returns>
    public static DialectReadResult Read(DialectFile root, IReadOnlyList<DialectFile> files)
    {
        if (root is null)
            throw new ArgumentNullException(nameof(root));
        if (files is null)
            throw new ArgumentNullException(nameof(files));
        var faults = new FaultList();
        var walk = new IncludeWalk(files, faults);
        IReadOnlyList<DefinitionElement> elements = walk.Walk(root);

        foreach (DefinitionElement file in elements)
            SchemaCheck.Check(file);
        // All enums first: a file may use an enum that a file beside it defines, and files without includes do.
        var enums = new EnumReader();
        foreach (DefinitionElement file in elements)
            Each(file, "enums", "enum", enums.Read);
        var messages = new MessageReader(enums);
        foreach (DefinitionElement file in elements)
            Each(file, "messages", "message", messages.Read);
        new EnumValueCheck(enums, messages.EnumUses, faults).Run();

        string name = Path.GetFileNameWithoutExtension(IncludePath.FileName(root.Path));
        return new DialectReadResult(
            new Dialect(name, enums.Enums, messages.Messages) { Parts = walk.Parts }, faults.Faults);
    }

    private static void Each(DefinitionElement file, string group, string name, Action<DefinitionElement> read)
    {
        foreach (XElement element in file.Element.Elements(group).Elements(name))
            read(file.Child(element));
    }
}
