using System;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Links;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Runs the simulated vehicle by the clock of the run: as many steps of 10 ms as have passed, then what is due goes
/// out over the link. A link that has ended is logged once; the vehicle goes on.
/// </summary>
internal sealed class SimulatedVehicleManager : RabitManager
{
    private const int FramesWaiting = 512;
    private static readonly TimeSpan StepTime = TimeSpan.OfSeconds(SimulatedVehicle.StepSeconds);

    private readonly SimulatedVehicle _vehicle;
    private readonly TruthRecorder _recorder;
    private readonly MavlinkLinkTarget _target;
    private readonly BlockingReader<LinkFrame> _reader;
    private readonly BlockingWriter<MavlinkFrame> _writer;
    private readonly DelayedFrames _delayed;
    private readonly VehicleSigning? _signing;
    private readonly TelemetryFaults _faults;
    private TimeSpan _stepped;
    private long _sent;
    private long _received;
    private long _lost;
    private bool _hasReportedEnd;
    private bool _hasReportedRejection;

    /// <param name="name">Of the manager.</param>
    /// <param name="vehicle">What flies.</param>
    /// <param name="delayed">The latency of its telemetry.</param>
    /// <param name="recorder">Keeps the truth.</param>
    /// <param name="link">Its telemetry.</param>
    /// <param name="signing">Null where the link is not signed.</param>
    /// <param name="faults">What is wrong with its telemetry.</param>
    public SimulatedVehicleManager(
        string name, SimulatedVehicle vehicle, DelayedFrames delayed, TruthRecorder recorder, IByteLink link,
        VehicleSigning? signing, TelemetryFaults faults)
        : base(name)
    {
        _signing = signing;
        _faults = faults;
        _vehicle = vehicle;
        _delayed = delayed;
        _recorder = recorder;
        _target = new MavlinkLinkTarget(link);
        _reader = AttachReader("link", new MavlinkLinkSource(link), FramesWaiting);
        _writer = AttachWriter("link out", _target, FramesWaiting);
    }

    protected override void Startup() => _stepped = Now;

    protected override void ExecuteUnitOfWork()
    {
        TimeSpan now = Now;
        DateTimeOffset utc = Clock.GetUtcNow();
        _signing?.Advance(utc, now);
        while (_stepped + StepTime <= now)
        {
            _stepped += StepTime;
            _vehicle.Step(_stepped, utc - (now - _stepped));
            Take(_stepped);
        }

        Receive(now);
        Deliver(now);
        _recorder.CountFrames(_sent, _received, _lost + _target.Lost);
        SleepUntil(now);
    }

    private void Receive(TimeSpan now)
    {
        while (_reader.TryPop(out LinkFrame received))
        {
            MavlinkFrame frame = received.Frame;

            // What no dialect knows, nothing could check.
            if (!received.IsChecked || _vehicle.IsSilent || _vehicle.IsBooting || !IsAccepted(frame))
            {
                _lost++;
                continue;
            }

            _received++;
            _vehicle.Handle(frame, now);
        }

        Take(now);
    }

    // Logged once: it explains why the vehicle does not answer.
    private bool IsAccepted(in MavlinkFrame frame)
    {
        if (_signing is null || _signing.Accepts(frame))
            return true;
        if (!_hasReportedRejection)
            Log(FormattableString.Invariant(
                $"a frame of {frame.SystemId}/{frame.ComponentId} was rejected: it is not signed with the key, or not in time; all such are"));
        _hasReportedRejection = true;
        return false;
    }

    private void Take(TimeSpan now)
    {
        while (_vehicle.TryTakeFrame(out MavlinkFrame frame))
            _delayed.Add(_faults.Pass(frame, now), now, _faults.DelayAt(now));
        while (_faults.TryTakeStale(now, out MavlinkFrame stale))
            _delayed.Add(stale, now, _faults.DelayAt(now));
    }

    private void Deliver(TimeSpan now)
    {
        while (_delayed.TryTake(now, out MavlinkFrame frame))
        {
            if (_vehicle.IsSilent || IsLinkGone()
                || _writer.Push(_signing is null ? frame : _signing.Sign(frame)) == PushResult.Rejected)
                _lost++;
            else
                _sent++;
        }
    }

    private bool IsLinkGone()
    {
        bool hasEnded = _reader.State is DeviceState.Ended or DeviceState.Faulted
            || _writer.State is DeviceState.Ended or DeviceState.Faulted;
        if (hasEnded && !_hasReportedEnd)
            Log("the link has ended; the vehicle flies on without it");
        _hasReportedEnd |= hasEnded;
        return hasEnded;
    }

    private void SleepUntil(TimeSpan now)
    {
        TimeSpan next = _stepped + StepTime;
        if (_delayed.NextDue < next)
            next = _delayed.NextDue;
        WakeUpDelay = next > now ? next - now : TimeSpan.FromTicks(1);
    }
}
