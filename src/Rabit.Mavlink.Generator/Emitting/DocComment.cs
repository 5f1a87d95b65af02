using System.Collections.Generic;
using System.Linq;
using System.Text;
using Rabit.Mavlink.Generator.Model;

namespace Rabit.Mavlink.Generator.Emitting;

/// <summary>XML docs of generated members: the definition's own words where it has any, and always the facts.</summary>
internal static class DocComment
{
    public static void Summary(SourceWriter writer, string summary) => writer.Line($"/// <summary>{summary}</summary>");

    public static void Remarks(SourceWriter writer, IReadOnlyList<string> paragraphs)
    {
        if (paragraphs.Count == 0)
            return;
        writer.Line("/// <remarks>");
        foreach (string paragraph in paragraphs)
            writer.Line($"/// <para>{paragraph}</para>");
        writer.Line("/// </remarks>");
    }

    public static string Code(string text) => $"<c>{Escape(text)}</c>";

    /// <summary>A sentence as it stands in a definition: escaped, and ended.</summary>
    public static string Sentence(string text)
    {
        string escaped = Escape(text.Trim());
        return escaped.EndsWith(".", System.StringComparison.Ordinal) ? escaped : escaped + ".";
    }

    public static IEnumerable<string> Marks(DefinitionMarks marks, string? replacedBy)
    {
        if ((marks & DefinitionMarks.WorkInProgress) != DefinitionMarks.None)
            yield return "Work in progress: its definition may still change.";
        if ((marks & DefinitionMarks.Deprecated) != DefinitionMarks.None)
            yield return "Deprecated by its definition: should no longer be sent.";
        if ((marks & DefinitionMarks.Superseded) != DefinitionMarks.None)
            yield return "Superseded by its definition: something newer does the same.";
        if (replacedBy is not null)
            yield return $"Replaced by {Escape(replacedBy)}.";
    }

    public static string Join(IEnumerable<string> sentences)
        => string.Join(" ", sentences.Where(sentence => sentence.Length != 0));

    public static string Escape(string text)
    {
        var escaped = new StringBuilder(text.Length);
        foreach (char character in text)
        {
            switch (character)
            {
                case '&': escaped.Append("&amp;"); break;
                case '<': escaped.Append("&lt;"); break;
                case '>': escaped.Append("&gt;"); break;
                default: escaped.Append(char.IsControl(character) ? ' ' : character); break;
            }
        }

        return escaped.ToString();
    }
}
