using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Documentation.Tests;

/// <summary>
/// Every example in the XML documentation of a package is code that compiles. Rabit.Core and Rabit.Mavlink have tests
/// of their own for it, which know their surroundings.
/// </summary>
public sealed class DocumentedExampleTests
{
    private static readonly string[] Packages =
        ["Geodesy", "Vision", "Links", "Uav", "Uav.Reporting", "Uav.Simulation"];

    private static readonly Dictionary<string, XmlDocExample> Found = Packages
        .SelectMany(p => XmlDocExample.In("src/Rabit." + p))
        .GroupBy(e => e.ToString(), StringComparer.Ordinal)
        .SelectMany(g => g.Select((e, i) => (Key: i == 0 ? g.Key : $"{g.Key} number {i + 1}", Example: e)))
        .ToDictionary(e => e.Key, e => e.Example, StringComparer.Ordinal);

    public static TheoryData<string> Examples => [.. Found.Keys];

    [Theory]
    [MemberData(nameof(Examples))]
    public void Example_OfAPackage_Compiles(string example)
    {
        IReadOnlyList<string> faults = CompiledExample.FindFaults(Found[example].Text);

        Assert.True(faults.Count == 0, $"{example}:\n{string.Join("\n", faults)}\n\n{Found[example].Text}");
    }

    [Theory]
    [InlineData("Geodesy")]
    [InlineData("Vision")]
    [InlineData("Links")]
    [InlineData("Uav")]
    [InlineData("Uav.Reporting")]
    [InlineData("Uav.Simulation")]
    public void Examples_OfEachPackage_AreAtLeastEight(string package)
        => Assert.InRange(XmlDocExample.In("src/Rabit." + package).Count, 8, int.MaxValue);

    [Theory]
    [InlineData("var world = new SimulatedWorlds();", "SimulatedWorlds")]
    [InlineData("LinkUrl url = 5;", "LinkUrl")]
    [InlineData("string text = null;", "null")]
    [InlineData(
        """
        sealed class Sleepy : RabitManager
        {
            public Sleepy() : base("sleepy") => WakeUpDelay = TimeSpan.FromSeconds(2);

            protected override void ExecuteUnitOfWork() => Thread.Sleep(1);
        }
        """,
        "RABIT0002")]
    public void FindFaults_WhatDoesNotCompile_IsNamed(string code, string expected)
        => Assert.Contains(expected, Assert.Single(CompiledExample.FindFaults(code)), StringComparison.Ordinal);
}
