using System;
using System.Linq;
using System.Reflection;
using Xunit;

namespace Rabit.Core.Tests.Predecessors;

/// <summary>Each defect that docs/concepts/predecessors.md lists has a test that names it.</summary>
public sealed class DefectCoverageTests
{
    // The numbers that are missing are of parts that Rabit.Core does not have: state machines, byte writers, code
    // generators.
    private static readonly string[] Defects =
    [
        .. Enumerable.Range(1, 24).Select(n => n.ToString(System.Globalization.CultureInfo.InvariantCulture)), "26",
        "27", "32", "C#"
    ];

    [Fact]
    public void Defects_ThatConcernCore_HaveATestThatNamesThem()
    {
        string[] named =
        [
            .. from type in typeof(DefectCoverageTests).Assembly.GetTypes()
               where !type.IsAbstract
               from method in type.GetMethods()
               where method.IsDefined(typeof(FactAttribute), inherit: true)
               from attribute in method.GetCustomAttributesData()
               where attribute.AttributeType == typeof(TraitAttribute)
                   && (string)attribute.ConstructorArguments[0].Value! == "Defect"
               select (string)attribute.ConstructorArguments[1].Value!,
        ];

        Assert.Empty(Defects.Except(named, StringComparer.Ordinal));
        Assert.Empty(named.Except(Defects, StringComparer.Ordinal));
    }
}
