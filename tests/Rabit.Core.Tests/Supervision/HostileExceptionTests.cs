using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Rabit.Core.Diagnostics;
using Rabit.Core.Tests.Contracts;
using Rabit.Core.Tests.Diagnostics;
using Rabit.Core.Tests.Messages;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Supervision;

/// <summary>
/// Contract 1.7: no exception, whatever its members do when they are read, ends the process or silences a manager.
/// Every place of the sources that reads the text of an exception is in a list here, and is tried.
/// </summary>
public sealed class HostileExceptionTests : InterruptingTests
{
    // Tried by tests of their own: below, and in LastResortTests, ExceptionTextTests and StandardErrorLogTests.
    private static readonly string[] OtherPlaces =
    [
        "Diagnostics/EventLog.cs", "Diagnostics/StandardErrorLog.cs", "Managers/ManagerActivity.LastResort.cs",
        "Messages/MessageBinding.cs", "Reactors/LastResort.cs", "Reactors/RabitReactor.cs", "Time/FailingSeed.cs",
    ];

    public static IEnumerable<object[]> Places()
        => from place in HostilePlaces.Names
           from engine in new[] { WaitEngine.Event, WaitEngine.Best }
           from hostility in new[] { Hostility.Throws, Hostility.ReturnsNull, Hostility.IsHuge, Hostility.Interrupts }
           select new object[] { place, engine, hostility };

    [Theory, Trait("Clause", "1.7"), Trait("Clause", "1.8"), Trait("Clause", "2.6")]
    [MemberData(nameof(Places))]
    public void Exception_WhateverItsMembersDo_IsReportedAndTheOthersContinue(
        string place, WaitEngine engine, Hostility hostility)
    {
        using var run = new TestRun(TimeKind.Real, o => o.Time = new RealTime { WaitEngine = engine });
        ScriptedManager bystander = run.Add("bystander");
        ScriptedManager manager = run.Add("m");
        manager.FaultPolicy = FaultPolicy.CarryOnAfter(TimeSpan.FromTicks(1), TimeSpan.FromTicks(1));
        HostilePlaces.Arrange(place, run, manager, () => throw new HostileException(hostility));

        run.Start();
        run.Until(() => manager.Units > 0, "the manager works");
        if (place.StartsWith("reader", StringComparison.Ordinal))
            run.Until(() => run.Board.Count(HostilePlaces.OpenEntry) > 0, "the reader opens its source");
        if (HostilePlaces.OnDeviceThread.Contains(place))
            run.Until(() => HasReported(run), "the device thread reports its fault");
        run.On(bystander, () => { });
        int units = manager.Units;
        manager.WakeUp();
        run.Until(() => manager.Units > units, "the manager continues");
        ReactorResult result = run.Finish();

        Assert.Equal(1, manager.Shutdowns);
        Assert.Equal(ManagerOutcome.Ended, result.Managers[0].Outcome);
        Assert.DoesNotContain(result.Managers, m => m.Outcome == ManagerOutcome.DidNotStop);
        if (place == "warm-up" && !OperatingSystem.IsLinux())
            return;
        Assert.True(HasReported(run));
        Assert.NotEmpty(result.ToString());
    }

    [Theory, Trait("Clause", "1.7"), Trait("Clause", "2.5")]
    [InlineData(Hostility.Throws)]
    [InlineData(Hostility.ReturnsNull)]
    [InlineData(Hostility.IsHuge)]
    public void Clone_ThatThrows_IsAFaultOfTheWiring(Hostility hostility)
    {
        var run = new TestRun(TimeKind.Real);
        run.Add("m").Publish("scan", new UnclonableScan(hostility));

        var thrown = Assert.Throws<RabitWiringException>(run.Start);

        Assert.Contains(nameof(HostileException), thrown.Message, StringComparison.Ordinal);
        Assert.InRange(thrown.Message.Length, 1, 2 * ExceptionText.MaxLength);
    }

    [Theory, Trait("Clause", "1.7"), Trait("Clause", "5.2")]
    [InlineData(Hostility.Throws)]
    [InlineData(Hostility.ReturnsNull)]
    [InlineData(Hostility.IsHuge)]
    public void EventLog_WriterThatThrows_FailsTheRunAndSaysSo(Hostility hostility)
    {
        using var run = new TestRun(
            TimeKind.Virtual, o => o.Time = new VirtualTime { EventLog = new FailingWriter(hostility) });
        ScriptedManager manager = run.Add("m");

        run.Start();
        ReactorResult result = run.FinishByItself();

        Assert.Equal(manager.Startups, manager.Shutdowns);
        Assert.IsType<HostileException>(Assert.IsType<IOException>(result.Failure).InnerException);
        Assert.StartsWith("The event log could not be written: ", result.StopReason, StringComparison.Ordinal);
    }

    [Theory, Trait("Clause", "1.7"), Trait("Clause", "5.2")]
    [InlineData(Hostility.Throws)]
    [InlineData(Hostility.ReturnsNull)]
    [InlineData(Hostility.IsHuge)]
    public void FailingSeed_OfAHostileException_HasAText(Hostility hostility)
    {
        FailingSeed? found = SeedSearch.Find(7, 1, _ => throw new HostileException(hostility));

        Assert.StartsWith("seed 7 fails: ", found!.ToString(), StringComparison.Ordinal);
    }

    [Fact, Trait("Clause", "1.7")]
    public void Sources_PlacesThatReadATextOfAnException_AreTheListed()
    {
        IEnumerable<string> found = Sources()
            .Where(s => s.Path != "Diagnostics/ExceptionText.cs" && s.Text.Contains("ExceptionText."))
            .Select(s => s.Path);

        Assert.Equal(
            HostilePlaces.Files.Concat(OtherPlaces).Distinct().OrderBy(p => p, StringComparer.Ordinal),
            found.OrderBy(p => p, StringComparer.Ordinal));
    }

    [Fact, Trait("Clause", "1.7")]
    public void Sources_OutsideTheHelper_ReadNoMemberOfAnException()
    {
        // The members that an exception may override, and an exception put into a text. ReactorLog's entries have a
        // Source too, so that of an exception is found by the names that exceptions have here.
        var reads = new Regex(
            @"\.(Message|StackTrace|HelpLink|TargetSite|GetBaseException)\b"
                + @"|\b(e|exception|unexpected|failure|fault|thrown)\.(ToString|Data|Source)\b"
                + @"|\{(e|exception|unexpected|failure|thrown)\}");

        // A ManagerFault keeps its text.
        IEnumerable<string> found =
            from source in Sources()
            where source.Path != "Diagnostics/ExceptionText.cs"
            from line in source.Text.Split('\n')
            where reads.IsMatch(line) && !line.Contains("fault.ToString()", StringComparison.Ordinal)
            select source.Path + ": " + line;

        Assert.Empty(found);
    }

    private static bool HasReported(TestRun run)
        => run.Log.Any(
            e => e.Text.Contains(nameof(HostileException)) && e.Text.Length < 2 * ExceptionText.MaxLength);

    private static IEnumerable<(string Path, string Text)> Sources()
    {
        string root = Path.Combine(Repository.Root, "src", "Rabit.Core");
        return Directory.GetFiles(root, "*.cs", SearchOption.AllDirectories)
            .Select(f => (f.Substring(root.Length + 1).Replace(Path.DirectorySeparatorChar, '/'), File.ReadAllText(f)));
    }

    private sealed class UnclonableScan(Hostility hostility) : ISelfCopying<UnclonableScan>
    {
        public UnclonableScan Clone() => throw new HostileException(hostility);

        public void CopyTo(UnclonableScan target) => throw new HostileException(hostility);
    }

    private sealed class FailingWriter(Hostility hostility) : StringWriter
    {
        public override void Write(char[] buffer, int index, int count) => throw new HostileException(hostility);
    }
}
