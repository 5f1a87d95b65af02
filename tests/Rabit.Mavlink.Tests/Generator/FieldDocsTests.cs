using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink.Generator.Emitting;
using Rabit.Mavlink.Generator.Model;
using Xunit;

namespace Rabit.Mavlink.Tests.Generator;

public class FieldDocsTests
{
    [Fact]
    public void Emit_EveryField_DocumentsUnitRangeInvalidValueAndEnum()
    {
        string[] lines = CSharpEmitter.Emit(Definitions.All, new EmitOptions("Check"))
            .SelectMany(source => source.Text.Split('\n')).ToArray();
        ILookup<string, string> docs = lines.Where(
            line => line.StartsWith("        /// <summary>", System.StringComparison.Ordinal) && line.Contains("<c>"))
            .ToLookup(line => line.Split(["<c>", "</c>"], System.StringSplitOptions.None)[1]);
        int facts = 0;
        foreach (FieldDefinition field in Definitions.All.Messages.SelectMany(message => message.Fields))
        {
            string[] expected = Expected(field).ToArray();
            facts += expected.Length;
            Assert.Contains(docs[field.Name], doc => expected.All(doc.Contains));
        }

        Assert.True(facts > 2000, $"only {facts} facts");
    }

    private static IEnumerable<string> Expected(FieldDefinition field)
    {
        if (field.Units is not null && field.Multiplier is null)
            yield return $"Unit: {field.Units}.";
        if (field.Units is not null && field.Multiplier is not null)
            yield return $"Unit: {field.Multiplier} {field.Units}.";
        if (field.MinValue is not null && field.MaxValue is not null)
            yield return $"Range: {field.MinValue} to {field.MaxValue}.";
        if (field.Invalid is not null)
            yield return $"Invalid value: <c>{field.Invalid}</c>.";
        if (field.Enum is not null)
            yield return "Values: <see cref=";
        if (field.IsExtension)
            yield return "Extension: ";
    }
}
