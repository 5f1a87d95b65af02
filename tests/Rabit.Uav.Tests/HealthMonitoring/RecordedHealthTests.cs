using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Uav.Tests.HealthMonitoring;

/// <summary>
/// docs/managers/health-monitoring.md says what the rules find in recorded flights of real autopilots: whole seconds
/// from the first record, and the reason.
/// </summary>
public sealed class RecordedHealthTests
{
    private const string Page = "docs/managers/health-monitoring.md";

    [RecordingsFact("autopilots")]
    public void SimulatedAutopilots_Recorded_AreAsDocumented() => AssertDocumented("autopilots");

    [RecordingsFact("real/tlogs/small")]
    public void RealFlights_Recorded_AreAsDocumented() => AssertDocumented("real/tlogs/small", "real/tlogs/more");

    private static void AssertDocumented(params string[] folders)
    {
        string[] wrong = folders.SelectMany(f => Directory.GetFiles(RecordedHealth.Folder(f)!, "*.tlog"))
            .OrderBy(Path.GetFileNameWithoutExtension, StringComparer.Ordinal)
            .Select(log => Line(Path.GetFileNameWithoutExtension(log), RecordedHealth.Play(log)))
            .Except(File.ReadAllLines(Path.Combine(Repository.Root, Page))).ToArray();
        Assert.True(
            wrong.Length == 0, $"{Page} should have these lines:{Environment.NewLine}"
                + string.Join(Environment.NewLine, wrong));
    }

    private static string Line(string name, List<string> found)
        => $"| {name} | {(found.Count == 0 ? "nothing" : string.Join(", ", found))} |";
}
