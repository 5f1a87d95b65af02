using System;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Flies the mission: waits for the vehicle, arms it, takes off, flies the lanes over the area, revisits what was
/// found, returns to launch and lands. Without a mission it observes and commands nothing.
/// </summary>
public sealed partial class MissionControlManager : RabitManager, IMissionOperator
{
    /// <summary>The name of the manager.</summary>
    public const string ManagerName = "mission control";

    private static readonly TimeSpan TickPeriod = TimeSpan.FromMilliseconds(200);
    private static readonly TimeSpan StatusPeriod = TimeSpan.FromSeconds(1);

    private readonly MessageSubscriber<VehicleState> _vehicle;
    private readonly MessageSubscriber<HealthReport> _health;
    private readonly MessageSubscriber<TrackList> _tracks;
    private readonly MessageSubscriber<CommandAuthority> _authority;
    private readonly MessageSubscriber<ImagingStatus> _imaging;
    private readonly MessageSubscriber<AutopilotParameters>? _parameters;
    private readonly MessageSubscriber<PreflightReport>? _preflight;
    private readonly QueueReceiver<VehicleCommandResult> _results;
    private readonly QueueReceiver<CameraObservation> _searchedGround;
    private readonly QueueSender<VehicleCommand> _commands;
    private readonly QueueSender<TrackDecision> _decisions;
    private readonly MessagePublisher<ImagingCommand> _imagingCommand;
    private readonly MessagePublisher<MissionStatus> _status;
    private readonly MissionFlight? _flight;
    private readonly MissionMachine? _machine;
    private readonly MissionAssessment _assessment = new();
    private readonly ProgressKeeper? _progress;
    private TimeSpan? _lastStatus;

    /// <summary>Makes the manager.</summary>
    /// <param name="options">Checked and read now; later changes have no effect.</param>
    /// <exception cref="ArgumentException">
    /// Options are out of their range, or the mission cannot be flown; the text names all faults.
    /// </exception>
    public MissionControlManager(MissionControlOptions options)
        : base(ManagerName)
    {
        MissionControlOptions copy = (options ?? throw new ArgumentNullException(nameof(options)))
            .ValidatedCopy(nameof(options));
        _vehicle = Subscribe<VehicleState>(MessageNames.VehicleState);
        _health = Subscribe<HealthReport>(MessageNames.Health);
        _tracks = Subscribe<TrackList>(MessageNames.Tracks);
        _authority = Subscribe<CommandAuthority>(MessageNames.CommandAuthority);
        _imaging = Subscribe<ImagingStatus>(MessageNames.Imaging);
        if (copy.Mission is not null && copy.RequiresPreflight)
        {
            // They are read where there is a checklist.
            _preflight = Subscribe<PreflightReport>(MessageNames.Preflight);
            _parameters = Subscribe<AutopilotParameters>(MessageNames.AutopilotParameters);
        }

        _results = Receive<VehicleCommandResult>(MessageNames.VehicleCommandResults);
        _searchedGround = Receive<CameraObservation>(
            MessageNames.SearchedGround, whenFull: QueueFullMode.DropOldest, wakeOnPush: false);
        _commands = Send<VehicleCommand>(MessageNames.VehicleCommands);
        _decisions = Send<TrackDecision>(MessageNames.TrackDecisions);
        _imagingCommand = Publish<ImagingCommand>(MessageNames.ImagingCommand);
        _status = Publish<MissionStatus>(MessageNames.Mission);
        WakeUpDelay = TickPeriod;
        if (copy.Mission is null)
            return;
        MissionPlan mission = copy.Resume?.Changes.ApplyTo(copy.Mission) ?? copy.InLayer(copy.Mission)!;
        var dispatcher = new CommandDispatcher(command => _commands.Push(command) != PushResult.Rejected, Log);
        _flight = new MissionFlight(
            mission, copy, dispatcher, Log, new OperatorActions(d => _decisions.Push(d) != PushResult.Rejected));
        _machine = new MissionMachine(_flight);
        _group = _flight.Group is { } group ? new GroupPort(this, group) : null;
        BlockingWriter<PlanJob> planner = AttachWriter("planner", new PlanMaker(), PlanMaker.MaxWaiting);
        _flight.Changes.Planner = job => planner.Push(job) != PushResult.Rejected;
        if (copy.ProgressFile is { } path)
        {
            var target = new ProgressFileTarget(path);
            _progress = new ProgressKeeper(
                _flight, target, AttachWriter("progress", target, ProgressKeeper.Snapshots));
        }
    }

    /// <summary>
    /// The state of the mission, for the thread of the manager; null without a mission.
    /// </summary>
    internal MissionFlight? Flight => _flight;

    /// <summary>
    /// Plans once as if home were in the area, and discards the plan: the real one, made in a unit of work when home is
    /// known, then finds its code compiled. On a small computer compiling alone takes longer than a unit of work may.
    /// </summary>
    protected override void Startup()
    {
        _group?.Begin(Clock.GetUtcNow());
        if (_flight is not null)
            FlightPlan.Create(_flight.Mission, _flight.Mission.Area[0], out _, isQuick: true);
    }

    /// <inheritdoc/>
    protected override void ExecuteUnitOfWork()
    {
        (MissionPhase Phase, MissionStopResult Stop) before = (_status.Value.Phase, _status.Value.StopResult);
        if (_flight is not null && _machine is not null)
        {
            _flight.IsStopRequested = IsStopRequested;
            FetchInputs(_flight);
            _group?.Receive(_flight);
            _flight.Touchdown.Update(_flight);
            _flight.Energy.Update(_flight);
            _assessment.Update(_flight);
            _machine.Tick();
            _group?.Update(_flight, _machine.Phase);
            PostImagingCommand(_flight, _machine);
            DelaysStop = _machine.Stop.Delays;
            bool hasStopped = _machine.Stop.Result is MissionStopResult.Held or MissionStopResult.Returning;
            _progress?.Update(_machine.Phase, hasStopped, Clock.GetUtcNow());
        }
        else
        {
            DropUnread();
        }

        MissionPhase phase = _machine?.Phase ?? MissionPhase.NoMission;
        MissionStopResult stop = _machine?.Stop.Result ?? MissionStopResult.None;
        if (_lastStatus is null || (phase, stop) != before || Now - _lastStatus.Value >= StatusPeriod)
            PostStatus(phase);
    }

    /// <summary>Where the stop did not wait for us, or not long enough, the status says so.</summary>
    protected override void Shutdown()
    {
        if (_flight is null || _machine is null)
            return;
        _flight.OperatorActions.Close(_flight);
        _flight.Operator.Close();
        _machine.Stop.End(_machine.Phase);
        PostStatus(_machine.Phase);
    }

    private void FetchInputs(MissionFlight flight)
    {
        flight.Now = Now;
        if (_vehicle.Fetch())
            (flight.Vehicle, flight.VehicleReportTime) = (_vehicle.Value, Now);
        if (_health.Fetch())
            flight.Health = _health.Value;
        flight.HealthAge = _health.Age;
        if (_authority.Fetch())
            flight.Authority = _authority.Value;
        if (_imaging.Fetch())
            flight.Imaging = _imaging.Value;
        if (_parameters?.Fetch() == true)
            flight.Energy.Parameters = _parameters.Value;
        if (_preflight?.Fetch() == true)
            flight.Preflight = _preflight.Value;
        while (_results.TryPop(out VehicleCommandResult result))
        {
            flight.Commands.Apply(result, flight.Now);
            flight.Camera.Apply(result);
        }

        while (_searchedGround.TryPop(out CameraObservation observation))
        {
            flight.Route?.Mark(observation);
            flight.Group?.Look(flight, observation);
        }

        if (!_tracks.Fetch())
            return;
        flight.Tracks = _tracks.Value;
        flight.OperatorActions.RejectAgain(flight);
        if (flight.Plan is not null)
            flight.Revisits.LogConfirmed(flight);
    }

    private void DropUnread()
    {
        while (_results.TryPop(out _))
        {
            // Without a mission there is no command to which it belongs.
        }

        while (_searchedGround.TryPop(out _))
        {
            // Without a mission there is no area to cover.
        }
    }

    private void PostImagingCommand(MissionFlight flight, MissionMachine machine)
    {
        // While Health Monitoring holds it the pictures are still judged: they may be the reason.
        ref ImagingCommand command = ref _imagingCommand.Value;
        ImagingMode mode = machine.Phase switch
        {
            MissionPhase.Revisiting when flight.IsFollowing => ImagingMode.Follow,
            MissionPhase.Searching or MissionPhase.Revisiting => ImagingMode.Search,
            MissionPhase.Holding when flight.IsHeldByHealth && command.Mode != ImagingMode.Off => ImagingMode.Search,
            _ => ImagingMode.Off,
        };
        if (command.Mode == mode)
            return;
        command.Mode = mode;
        command.CameraPitch = flight.Mission.CameraPitch;
        command.CameraYaw = flight.Mission.CameraYaw;
        command.GroundAltitudeAmslMetres = flight.GroundAltitudeAmslMetres;
        command.Classes = flight.Mission.Targets;
        _imagingCommand.Post();
    }

    private void PostStatus(MissionPhase phase)
    {
        ref MissionStatus status = ref _status.Value;
        status.Phase = phase;
        if (_flight is not null && _machine is not null)
        {
            status.Since = _machine.Since;
            status.Text = _flight.Text;
            status.Aborted = _flight.Aborted;
            status.TakenOver = _flight.TakenOver;
            status.StopResult = _machine.Stop.Result;
            status.Plan = _flight.Plan?.Message;
            status.LanesFlown = _flight.Route?.Flown ?? 0;
            status.LanesSkipped = _flight.Route?.Skipped ?? 0;
            status.Coverage = _flight.SeenFraction;
            status.Revisits = _flight.Revisits.Completed;
            status.Energy = _flight.Energy.Status;
            status.RevisitsFailed = _flight.Revisits.Failed;
            status.CameraClock = _flight.Tracks.CameraClock;
            status.TracksConfirmed = _flight.Tracks.ConfirmedCount;
            status.TracksRejected = _flight.Tracks.RejectedCount;
            status.TracksNotConfirmed =
                _flight.Tracks.Tracks.Length - status.TracksConfirmed - status.TracksRejected;
            status.RevisitsLeftOut = _flight.Revisits.LeftOut;
            status.Result = _assessment.Assess(_flight, phase);
        }
        else
        {
            status.Text = "no mission: observing";
        }

        _status.Post();
        _group?.Post(Now);
        _lastStatus = Now;
    }
}
