using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using Rabit.Core.Tests.Contracts;
using Xunit;

namespace Rabit.Core.Tests;

/// <summary>
/// Every clause of the contract that is due has a test that names it, and every contract is kept in both kinds of time.
/// </summary>
public sealed partial class ClauseCoverageTests
{
    private static readonly string[] DueClauses =
    [
        "1.1", "1.2", "1.3", "1.4", "1.5", "1.6", "1.7", "1.8", "1.9",
        "2.1", "2.2", "2.3", "2.4", "2.5", "2.6", "2.7", "2.8",
        "3.1", "3.2", "3.3", "3.4", "3.5",
        "4.1", "4.2", "4.3", "4.4", "4.5",
        "5.1", "5.2",
    ];

    // About threads alone, or about virtual time alone, or the same whatever the time.
    private static readonly string[] ClausesOfOneTime = ["2.4", "3.3", "4.5", "5.2"];

    [Fact]
    public void Clauses_ThatAreDue_HaveATestThatNamesThem()
        => Assert.Empty(DueClauses.Except(ClausesIn(_ => true), StringComparer.Ordinal));

    [Fact]
    public void Clauses_ThatAreDue_HaveATestInEachKindOfTime()
    {
        IEnumerable<string> expected = DueClauses.Except(ClausesOfOneTime, StringComparer.Ordinal).ToArray();
        foreach (TimeKind kind in new[] { TimeKind.Real, TimeKind.Virtual })
        {
            IEnumerable<string> found = ClausesIn(type => KindOf(type) == kind);
            Assert.Equal("", string.Join(" ", expected.Except(found, StringComparer.Ordinal)));
        }
    }

    [Fact]
    public void Clauses_ThatTestsName_AreClausesOfTheContract()
        => Assert.Empty(ClausesIn(_ => true).Except(DueClauses, StringComparer.Ordinal));

    [Fact]
    public void Contracts_Each_AreTestedInBothKindsOfTime()
    {
        Type[] types = typeof(ContractTests).Assembly.GetTypes();
        Type[] contracts = types.Where(t => t.IsAbstract && t.BaseType == typeof(ContractTests)).ToArray();

        Assert.NotEmpty(contracts);
        foreach (Type contract in contracts)
        {
            TimeKind?[] kinds = types.Where(t => t.BaseType == contract).Select(KindOf).ToArray();
            Assert.Equal(2, kinds.Length);
            Assert.Contains(TimeKind.Real, kinds);
            Assert.Contains(TimeKind.Virtual, kinds);
        }
    }

    private static HashSet<string> ClausesIn(Func<Type, bool> isWanted)
        => new(Tests().Where(t => isWanted(t.Type)).Select(t => t.Clause), StringComparer.Ordinal);

    private static IEnumerable<(Type Type, string Clause)> Tests()
        => from type in typeof(ClauseCoverageTests).Assembly.GetTypes()
           where !type.IsAbstract
           from method in type.GetMethods()
           where method.IsDefined(typeof(FactAttribute), inherit: true)
           from clause in Clauses(method).Concat(Clauses(type))
           select (type, clause);

    private static IEnumerable<string> Clauses(MemberInfo member)
        => from attribute in member.GetCustomAttributesData()
           where attribute.AttributeType == typeof(TraitAttribute)
               && (string)attribute.ConstructorArguments[0].Value! == "Clause"
           select (string)attribute.ConstructorArguments[1].Value!;

    private static TimeKind? KindOf(Type type)
    {
        if (!typeof(ContractTests).IsAssignableFrom(type) || type.IsAbstract)
            return null;
        return ((ContractTests)Activator.CreateInstance(type)!).Kind;
    }
}
