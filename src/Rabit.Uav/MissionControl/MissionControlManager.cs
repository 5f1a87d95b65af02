using System;
using System.Threading;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Flies the mission: waits for the vehicle, arms it, takes off, flies the lanes over the area, revisits what was
/// found, returns to launch and lands. Without a mission it observes and commands nothing.
/// </summary>
public sealed class MissionControlManager : RabitManager
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
    private readonly QueueReceiver<VehicleCommandResult> _results;
    private readonly QueueReceiver<CameraObservation> _searchedGround;
    private readonly QueueSender<VehicleCommand> _commands;
    private readonly MessagePublisher<ImagingCommand> _imagingCommand;
    private readonly MessagePublisher<MissionStatus> _status;
    private readonly MissionFlight? _flight;
    private readonly MissionMachine? _machine;
    private readonly MissionAssessment _assessment = new();
    private TimeSpan? _lastStatus;
    private string? _abort; // written by any thread, read by this manager; replaced as a whole

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
        _results = Receive<VehicleCommandResult>(MessageNames.VehicleCommandResults);
        _searchedGround = Receive<CameraObservation>(
            MessageNames.SearchedGround, whenFull: QueueFullMode.DropOldest, wakeOnPush: false);
        _commands = Send<VehicleCommand>(MessageNames.VehicleCommands);
        _imagingCommand = Publish<ImagingCommand>(MessageNames.ImagingCommand);
        _status = Publish<MissionStatus>(MessageNames.Mission);
        WakeUpDelay = TickPeriod;
        if (copy.Mission is null)
            return;
        var dispatcher = new CommandDispatcher(command => _commands.Push(command) != PushResult.Rejected, Log);
        _flight = new MissionFlight(copy.Mission, copy, dispatcher, Log);
        _machine = new MissionMachine(_flight);
    }

    /// <summary>
    /// Aborts the mission: the vehicle returns to launch; before take-off it stays where it is. Returns at once; does
    /// nothing when the mission is over or there is none. Only the first reason counts. Any thread.
    /// </summary>
    /// <param name="reason">Why, as text for the status and the log.</param>
    public void Abort(string reason)
    {
        if (string.IsNullOrWhiteSpace(reason))
            throw new ArgumentException("An abort needs a reason.", nameof(reason));
        Interlocked.CompareExchange(ref _abort, reason, null);
        WakeUp();
    }

    /// <summary>
    /// Plans once as if home were in the area, and discards the plan: the real one, made in a unit of work when home is
    /// known, then finds its code compiled. On a small computer compiling alone takes longer than a unit of work may.
    /// </summary>
    protected override void Startup()
    {
        if (_flight is not null)
            FlightPlan.Create(_flight.Mission, _flight.Mission.Area[0], out _);
    }

    /// <inheritdoc/>
    protected override void ExecuteUnitOfWork()
    {
        MissionPhase before = _status.Value.Phase;
        if (_flight is not null && _machine is not null)
        {
            FetchInputs(_flight);
            _assessment.Update(_flight);
            _machine.Tick(Volatile.Read(ref _abort));
            PostImagingCommand(_flight, _machine);
        }
        else
        {
            DropUnread();
        }

        MissionPhase phase = _machine?.Phase ?? MissionPhase.NoMission;
        if (_lastStatus is null || phase != before || Now - _lastStatus.Value >= StatusPeriod)
            PostStatus(phase);
    }

    private void FetchInputs(MissionFlight flight)
    {
        flight.Now = Now;
        if (_vehicle.Fetch())
            flight.Vehicle = _vehicle.Value;
        if (_health.Fetch())
            flight.Health = _health.Value;
        if (_authority.Fetch())
            flight.Authority = _authority.Value;
        if (_imaging.Fetch())
            flight.Imaging = _imaging.Value;
        while (_results.TryPop(out VehicleCommandResult result))
            flight.Commands.Apply(result, flight.Now);
        while (_searchedGround.TryPop(out CameraObservation observation))
            flight.Route?.Mark(observation);
        if (!_tracks.Fetch())
            return;
        flight.Tracks = _tracks.Value;
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
        bool searches = machine.Phase is MissionPhase.Searching or MissionPhase.Revisiting;
        ref ImagingCommand command = ref _imagingCommand.Value;
        ImagingMode mode = searches ? ImagingMode.Search : ImagingMode.Off;
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
            status.Plan = _flight.Plan?.Message;
            status.LanesFlown = _flight.Route?.Flown ?? 0;
            status.Coverage = _flight.Route?.Coverage.Fraction ?? 0;
            status.Revisits = _flight.Revisits.Completed;
            status.Result = _assessment.Assess(_flight, phase);
        }
        else
        {
            status.Text = "no mission: observing";
        }

        _status.Post();
        _lastStatus = Now;
    }
}
