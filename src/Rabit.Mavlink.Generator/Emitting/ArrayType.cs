using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink.Generator.Model;

namespace Rabit.Mavlink.Generator.Emitting;

/// <summary>A value type that holds an array field: <c>UInt16Array4</c>, or <c>Text16</c> for characters.</summary>
internal sealed record ArrayType(string Element, string ElementClrName, int ElementSize, int Length, bool IsText)
{
    public string Name => IsText ? $"Text{Length}" : $"{(Element == "float" ? "Float" : ElementClrName)}Array{Length}";

    /// <summary>How many 64-bit words hold the elements.</summary>
    public int Words => ((ElementSize * Length) + 7) / 8;

    public static ArrayType Of(FieldDefinition field) =>
        new(field.Type.CSharpName, field.Type.ClrName, field.Type.Size, field.ArrayLength, field.IsText);

    public static IReadOnlyList<ArrayType> AllOf(IEnumerable<MessageDefinition> messages) =>
        messages.SelectMany(message => message.Fields).Where(field => field.ArrayLength != 0).Select(Of).Distinct()
            .OrderBy(array => array.Name, System.StringComparer.Ordinal).ToList();
}
