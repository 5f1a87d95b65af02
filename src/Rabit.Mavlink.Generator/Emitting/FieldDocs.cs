using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink.Generator.Model;
using Rabit.Mavlink.Generator.Naming;

namespace Rabit.Mavlink.Generator.Emitting;

/// <summary>What the doc of a property says: what the definition says of the field.</summary>
internal static class FieldDocs
{
    public static void Write(SourceWriter writer, FieldDefinition field, GeneratedTypeNames names, bool isRenamed)
    {
        List<string> facts = Facts(field, names).ToList();
        string head = field.Description is null ? "" : DocComment.Sentence(field.Description);
        if (isRenamed)
            facts.Add("Not called like its field, since a C# member cannot have the name of its type.");
        DocComment.Summary(writer, DocComment.Join(new[] { head, What(field) }.Concat(facts)));
    }

    private static string What(FieldDefinition field)
    {
        string what = field.IsText ? $"text of at most {field.ArrayLength} characters"
            : field.ArrayLength != 0 ? $"{field.ArrayLength} elements of {field.Type.Name}"
            : field.Type.Name;
        return $"{DocComment.Code(field.Name)}, {what}.";
    }

    private static IEnumerable<string> Facts(FieldDefinition field, GeneratedTypeNames names)
    {
        if (field.Units is not null)
            yield return field.Multiplier is null
                ? $"Unit: {DocComment.Escape(field.Units)}."
                : $"Unit: {DocComment.Escape(field.Multiplier)} {DocComment.Escape(field.Units)}.";
        else if (field.Multiplier is not null)
            yield return $"One count is {DocComment.Escape(field.Multiplier)}.";
        if (field.Enum is not null)
            yield return $"Values: <see cref=\"{names.OfEnum(field.Enum)}\"/>.";
        if (field.MinValue is not null && field.MaxValue is not null)
            yield return $"Range: {DocComment.Escape(field.MinValue)} to {DocComment.Escape(field.MaxValue)}.";
        else if (field.MinValue is not null)
            yield return $"At least {DocComment.Escape(field.MinValue)}.";
        else if (field.MaxValue is not null)
            yield return $"At most {DocComment.Escape(field.MaxValue)}.";
        if (field.Invalid is not null)
            yield return $"Invalid value: {DocComment.Code(field.Invalid)}.";
        if (field.IsInstance)
            yield return "Distinguishes several instances of this message.";
        if (field.IsExtension)
            yield return "Extension: zero from senders of MAVLink 1 and from those that do not know it.";
    }
}
