using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;
using Rabit.Uav.Preflight;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// Reads the parameters of the checklist and of the return, writes failsafes and fence before a flight, and writes the
/// autopilot's own ones back after it. A queue of steps, one after another; frames in and out, time as argument, no I/O
/// but the store. Nothing is read or written in flight. One thread.
/// </summary>
internal sealed partial class AutopilotSetup
{
    // A name that the autopilot does not know is not answered: few tries, and all names again some times.
    private const int ReadRounds = 3;
    private static readonly MavlinkParameterOptions ParameterTimes = new() { Retries = 1 };

    // A value that the operator changes at another ground station is seen at once; this is for a report that is lost.
    private static readonly TimeSpan ReadAgainAfter = TimeSpan.FromSeconds(10);

    private readonly AutopilotSetupOptions _options;
    private readonly IOriginalsStore? _store;
    private readonly Action<string> _log;
    private readonly MavlinkParameterClient _parameters;
    private readonly MavlinkMissionClient _fence;
    private readonly KnownParameters _known;
    private readonly Queue<SetupStep> _steps = new();
    private readonly List<string> _faults = [];
    private SetupStep? _step;
    private bool _hasStarted;
    private int _round;
    private bool _isComplete;
    private TimeSpan _readAt;

    // What was found on disk, or is kept there by now.
    private Originals? _originals;
    private bool _hasLoaded;
    private bool _hasFlown;
    private bool _hasWritten;
    private bool _hasRestored;
    private AutopilotSetupState _state;
    private string? _text;

    /// <param name="vehicle">Its make and kind decide what is read.</param>
    /// <param name="sender">Gives the frames their source.</param>
    /// <param name="target">The autopilot.</param>
    /// <param name="options">What is to be written.</param>
    /// <param name="store">Keeps the originals; null where nothing is written.</param>
    /// <param name="log">Takes what people should know.</param>
    public AutopilotSetup(
        in VehicleState vehicle, MavlinkSender sender, MavlinkAddress target, AutopilotSetupOptions options,
        IOriginalsStore? store, Action<string> log)
    {
        (_options, _store, _log) = (options, store, log);
        MavAutopilot autopilot = vehicle.Autopilot;
        MavlinkParameterEncoding encoding = MavlinkParameter.EncodingOf(autopilot);
        _parameters = new MavlinkParameterClient(sender, target, encoding, ParameterTimes);
        _fence = new MavlinkMissionClient(sender, target);
        IEnumerable<IReadOnlyList<string>> groups = PreflightRules.ParametersOf(
                autopilot, FixedWings.IsFixedWing(vehicle.VehicleType))
            .Select(r => (IReadOnlyList<string>)r.Names.Select(n => n.Name).ToArray());
        IEnumerable<string> others = FenceParameters(autopilot).Select(p => p.Name)
            .Concat(ReturnSpeed.ParametersOf(autopilot));
        _known = new KnownParameters(
            groups.Concat(others.Select(n => (IReadOnlyList<string>)[n])).ToArray(), encoding);
        _state = options.Writes ? AutopilotSetupState.Writing : AutopilotSetupState.None;
        QueueReading(onlyUnknown: false);
    }

    /// <summary>Whether something is under way, so that answers are due soon.</summary>
    public bool IsBusy => _step is not null || _steps.Count > 0;

    /// <summary>
    /// Whether there is something to write back, on the ground: a program that is to end should wait for it.
    /// </summary>
    public bool MustRestore { get; private set; }

    /// <summary>How often a fence was written, or may have been.</summary>
    public int FenceWrites { get; private set; }

    /// <summary>Takes what is new to post; once.</summary>
    public bool TryTakeReport(out AutopilotParameters report)
    {
        report = AutopilotParameters.None;
        if (!_known.HasChanged)
            return false;
        _known.HasChanged = false;
        report = new AutopilotParameters
        {
            IsComplete = _isComplete,
            All = _known.ToArray(),
            Setup = _state,
            SetupText = _text,
        };
        return true;
    }

    /// <summary>Takes a frame of the autopilot; all but parameters and fences are ignored.</summary>
    public void Handle(in MavlinkFrame frame, TimeSpan now)
    {
        _parameters.Handle(frame, now);
        _fence.Handle(frame, now);
        if (frame.TryDecode(out ParamValue value))
            _known.Handle(value);
    }

    public bool TryTakeFrame(TimeSpan now, out MavlinkFrame frame)
        => _parameters.TryTakeFrame(now, out frame) || _fence.TryTakeFrame(now, out frame);

    /// <summary>The autopilot has started again: on the ground all is read again.</summary>
    public void HandleReboot(TimeSpan now)
    {
        _parameters.Cancel(now);
        _known.Clear();
        _isComplete = false;
        _round = 0;
        if (!IsBusy)
            QueueReading(onlyUnknown: false);
    }

    /// <summary>
    /// Goes on; only on the ground with the motors off, where nothing that is written can change a flight.
    /// </summary>
    /// <param name="facts">Vehicle, own address and time; the parameters are filled in here.</param>
    /// <param name="isStopping">Whether the program is to end: then what was written is written back.</param>
    public void Run(PreflightFacts facts, bool isStopping)
    {
        VehicleState vehicle = facts.Vehicle;
        if (!vehicle.IsConnected || vehicle.IsArmed || IsInAir(vehicle))
        {
            _hasFlown |= vehicle.IsArmed;
            MustRestore = false;
            return;
        }

        if (_store is not null && !_hasLoaded)
            Load(vehicle.SystemId);
        RunSteps(facts.Now);
        MustRestore = _originals is not null && !(_hasRestored && _state == AutopilotSetupState.Failed);
        if (IsBusy)
            return;
        if (!_isComplete)
            NextRound(facts.Now);
        else if (!TryQueueWriting(facts, isStopping) && facts.Now - _readAt >= ReadAgainAfter)
            ReadAgain(facts.Now);
    }

    private static bool IsInAir(in VehicleState vehicle)
        => vehicle.LandedState is MavLandedState.InAir or MavLandedState.Takeoff or MavLandedState.Landing;

    private void RunSteps(TimeSpan now)
    {
        while (_step is not null || _steps.Count > 0)
        {
            if (_step is null)
            {
                _step = _steps.Dequeue();
                _hasStarted = false;
                FenceWrites += _step is FenceWriteStep ? 1 : 0;
            }

            _hasStarted = _hasStarted || _step.TryStart(now);
            if (!_hasStarted || !_step.TryFinish(now, out string? fault))
                return;
            _step = null;
            if (fault is null)
                continue;
            _faults.Add(fault);
            _log(fault);
        }
    }

    private void QueueReading(bool onlyUnknown)
    {
        foreach (string name in _known.NamesToRead(onlyUnknown))
            _steps.Enqueue(new ReadStep(_parameters, _known, name));
    }

    private void NextRound(TimeSpan now)
    {
        _round++;
        QueueReading(onlyUnknown: true);
        if (IsBusy && _round < ReadRounds)
            return;
        _steps.Clear();
        _isComplete = true;
        _readAt = now;
        _known.HasChanged = true;
    }

    private void ReadAgain(TimeSpan now)
    {
        _readAt = now;
        QueueReading(onlyUnknown: false);
    }

    // With a new text the report is posted again.
    private void Set(AutopilotSetupState state, string? text)
    {
        (_state, _text) = (state, text);
        _known.HasChanged = true;
    }
}
