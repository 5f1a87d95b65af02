using System;
using System.Collections.Generic;
using System.IO;
using Rabit.Geodesy;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Xunit;

namespace Rabit.Uav.Tests.AutopilotInterface;

/// <summary>The monitors of targets on recorded flights of the real autopilots (tests/data/autopilots).</summary>
public class TargetRecordingTests
{
    private const byte Companion = 191;

    // Of ap-guided-other-commander: GLOBAL_POSITION_INT, altitude less height above home.
    private const double HomeAltitude = 7.067;

    // When the ground station commanded there.
    private const double OtherTarget = 17.922;
    private const double OtherVelocity = 32.948;

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void ArduPilot_AnotherCommanderInGuided_IsNoticedAndOurTargetsAreNot(bool knowsOrigin)
    {
        var monitor = new TargetMonitor();
        var noticed = new List<double>();
        foreach ((double time, MavlinkFrame frame) in Read("ap-guided-other-commander.targets.tlog"))
        {
            if (time > OtherVelocity + 2)
                break;
            Feed(monitor, time, frame, knowsOrigin);
            if (!frame.TryDecode(out PositionTargetLocalNed target) || !monitor.IsOfAnother(target, At(time)))
                continue;
            noticed.Add(time);
            monitor.Stop();
        }

        Assert.Equal(2, noticed.Count);
        Assert.InRange(noticed[0], OtherTarget, OtherTarget + 0.6);
        Assert.InRange(noticed[1], OtherVelocity, OtherVelocity + 0.6);
    }

    [Theory]
    [InlineData("px4-offboard.targets.tlog", 100)]
    [InlineData("px4-link-loss.targets.tlog", 70)]
    public void Px4_OurSetPointsInOffboard_AreReportedAndAreOurs(string file, int atLeast)
    {
        var flight = new OffboardFlight();
        foreach ((double time, MavlinkFrame frame) in Read(file))
        {
            flight.Take(time, frame);
            Assert.False(flight.IsForeign, FormattableString.Invariant($"at {time:0.00} s"));
        }

        Assert.InRange(flight.Reports, atLeast, 2000);
    }

    [Fact]
    public void Px4_EveryFourthReportIsAnothers_IsNoticedWithinTwoSeconds()
    {
        const double From = 22;
        var flight = new OffboardFlight();
        double? noticed = null;
        int report = 0;
        foreach ((double time, MavlinkFrame frame) in Read("px4-offboard.targets.tlog"))
        {
            bool isReport = frame.TryDecode(out PositionTargetLocalNed target);
            if (isReport && time > From && ++report % 4 == 1)
                target.X += 20;
            flight.Take(time, isReport ? MavlinkFrame.Create(target, 1, 1, 0) : frame);
            if (flight.IsForeign)
                noticed ??= time;
        }

        Assert.NotNull(noticed);
        Assert.InRange(noticed.Value, From, From + 2.5);
    }

    private static void Feed(TargetMonitor monitor, double time, in MavlinkFrame frame, bool knowsOrigin)
    {
        if (knowsOrigin && frame.TryDecode(out GpsGlobalOrigin origin))
            monitor.TakeOrigin(origin);
        if (frame.ComponentId == Companion && frame.TryDecode(out CommandInt place))
            monitor.Ask(new MavlinkCommand { X = place.X, Y = place.Y, Z = place.Z }, HomeAltitude);
        if (!frame.TryDecode(out CommandAck answer) || answer.TargetComponent != Companion)
            return;
        if (answer.Command == MavCmd.NavTakeoff)
            monitor.BeginTakeOff(At(time));
        else if (answer.Command == MavCmd.DoReposition)
            monitor.Acknowledge(At(time));
    }

    private static TimeSpan At(double seconds) => TimeSpan.FromSeconds(seconds);

    private static IEnumerable<(double Time, MavlinkFrame Frame)> Read(string name)
    {
        using FileStream file = File.OpenRead(TestData.AutopilotPathOf(name));
        var log = new TlogReader(file, MavlinkDialect.All);
        long? start = null;
        while (log.TryRead(out MavlinkFrame frame, out TlogRecord record))
        {
            start ??= record.TimeMicroseconds;
            yield return ((record.TimeMicroseconds - start.Value) * 1e-6, frame);
        }
    }

    /// <summary>What Autopilot Interface gives the monitor in OFFBOARD.</summary>
    private sealed class OffboardFlight
    {
        private readonly SetPointMonitor _monitor = new();
        private double _modeSince;
        private double _streamSince;
        private double _sentAt = double.NegativeInfinity;
        private uint _mode;

        public int Reports { get; private set; }

        /// <summary>A report of OFFBOARD after the monitor noticed another commander.</summary>
        public bool IsForeign { get; private set; }

        public void Take(double time, in MavlinkFrame frame)
        {
            if (frame.TryDecode(out Heartbeat heartbeat))
            {
                _modeSince = heartbeat.CustomMode == _mode ? _modeSince : time;
                _mode = heartbeat.CustomMode;
                IsForeign |= _mode == Px4Modes.Offboard && _monitor.ForeignSince < At(time);
            }
            else if (frame.TryDecode(out SetPositionTargetGlobalInt sent))
            {
                if (time - _sentAt > 0.5)
                {
                    _streamSince = time;
                    _monitor.Restart();
                }

                _sentAt = time;
                _monitor.TakeSent(
                    GeodeticPosition.FromDegrees(sent.LatInt / 1e7, sent.LonInt / 1e7, 0), sent.Alt, At(time));
            }
            else if (frame.TryDecode(out PositionTargetLocalNed target) && _mode == Px4Modes.Offboard
                && time - _sentAt < 0.5 && time - _streamSince > 1 && time - _modeSince > 0.6)
            {
                Reports++;
                _monitor.TakeReport(target, At(time));
            }
        }
    }
}
