using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Mavlink.Generator.Model;
using Rabit.Mavlink.Generator.Naming;

namespace Rabit.Mavlink.Generator.Emitting;

/// <summary>
/// Writes the entries that a dialect adds to an enum of the package: constants of the package's type, so that an enum
/// is one type and its values go into messages of both without a cast.
/// </summary>
internal sealed class EnumEntriesEmitter(Dialect dialect, GeneratedTypeNames names, SourceWriter writer)
{
    // What every class has from object; a constant of that name would hide it.
    private static readonly HashSet<string> Inherited = new(StringComparer.Ordinal)
    {
        "Equals", "GetHashCode", "GetType", "ToString", "Finalize", "MemberwiseClone", "ReferenceEquals",
    };

    public void Emit(EnumDefinition definition)
    {
        string type = names.OfEnum(definition.Name);
        string className = names.OfAddedEntries(definition.Name);
        IReadOnlyDictionary<string, string> entryNames = EntryNames.Of(definition);
        IReadOnlyList<EnumEntry> added = names.AddedEntries(definition);
        string files = $"{DocComment.Escape(dialect.Name)}.xml and the files it includes";
        DocComment.Summary(
            writer, $"What {files} add to {DocComment.Code(definition.Name)}: values of <see cref=\"{type}\"/>.");
        DocComment.Remarks(
            writer,
            ["<c>ToString</c> of these values gives their number; <c>FindEnum</c> of the dialect knows their names."]);
        writer.Open($"public static class {className}");
        bool isFirst = true;
        foreach (EnumEntry entry in added)
        {
            if (!isFirst)
                writer.Blank();
            isFirst = false;
            EnumEmitter.EmitDocs(writer, entry);
            string name = entryNames[entry.Name];
            if (Inherited.Contains(name) || name == className)
                name += "Entry";
            string value = entry.Value.ToString(CultureInfo.InvariantCulture);
            writer.Line($"public const {type} {name} = ({type})({value});");
        }

        writer.Close();
    }
}
