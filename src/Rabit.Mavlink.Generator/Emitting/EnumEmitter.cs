using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Mavlink.Generator.Model;
using Rabit.Mavlink.Generator.Naming;

namespace Rabit.Mavlink.Generator.Emitting;

/// <summary>Writes one enum.</summary>
internal sealed class EnumEmitter(Dialect dialect, GeneratedTypeNames names, SourceWriter writer)
{
    public void Emit(EnumDefinition definition)
    {
        IReadOnlyDictionary<string, string> entryNames = EntryNames.Of(definition);
        string kind = definition.IsBitmask ? "bit mask" : "enum";
        string fact = $"{DocComment.Code(definition.Name)}, {kind} with {definition.Entries.Count} "
            + $"{(definition.Entries.Count == 1 ? "entry" : "entries")}.";
        DocComment.Summary(writer, definition.Description is null ? fact : DocComment.Sentence(definition.Description));
        DocComment.Remarks(writer, (definition.Description is null ? [] : new[] { fact })
            .Concat(DocComment.Marks(definition.Marks, replacedBy: null)).ToList());
        if (definition.IsBitmask)
            writer.Line("[global::System.Flags]");
        WireType underlying = EnumUnderlyingType.Of(definition, dialect);
        writer.Open($"public enum {names.OfEnum(definition.Name)} : {underlying.CSharpName}");
        bool isFirst = true;
        foreach (EnumEntry entry in definition.Entries)
        {
            if (!isFirst)
                writer.Blank();
            isFirst = false;
            EmitEntry(entry, entryNames[entry.Name], underlying);
        }

        writer.Close();
    }

    /// <summary>The documentation of one entry.</summary>
    public static void EmitDocs(SourceWriter writer, EnumEntry entry)
    {
        string code = DocComment.Code(entry.Name) + ".";
        DocComment.Summary(
            writer, entry.Description is null ? code : DocComment.Join([DocComment.Sentence(entry.Description), code]));
        DocComment.Remarks(writer, DocComment.Marks(entry.Marks, entry.ReplacedBy)
            .Concat(entry.Parameters.Select(Describe).Where(text => text.Length != 0)).ToList());
    }

    private void EmitEntry(EnumEntry entry, string name, WireType underlying)
    {
        EmitDocs(writer, entry);
        string value = entry.Value.ToString(CultureInfo.InvariantCulture);
        writer.Line(
            entry.Value <= underlying.Max
                ? $"{name} = {value},"
                : $"{name} = unchecked(({underlying.CSharpName}){value}),");
    }

    private static string Describe(CommandParameter parameter)
    {
        var facts = new List<string>();
        if (parameter.Label is not null)
            facts.Add(DocComment.Escape(parameter.Label));
        if (parameter.Units is not null)
            facts.Add($"unit {DocComment.Escape(parameter.Units)}");
        if (parameter.Enum is not null)
            facts.Add($"values of {DocComment.Code(parameter.Enum)}");
        if (parameter.MinValue is not null)
            facts.Add($"at least {DocComment.Escape(parameter.MinValue)}");
        if (parameter.MaxValue is not null)
            facts.Add($"at most {DocComment.Escape(parameter.MaxValue)}");
        if (parameter.Description is not null)
            facts.Add(DocComment.Escape(parameter.Description));
        return facts.Count == 0 ? "" : $"Parameter {parameter.Index}: {string.Join(", ", facts)}.";
    }
}
