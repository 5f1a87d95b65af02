using System;
using System.Threading;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Flies the mission: waits for the vehicle, has it arm and take off, flies the lanes over the area, looks again at what was found,
/// brings the vehicle home. Without a mission it observes, and commands nothing.
/// </summary>
public sealed class MissionControlManager : RabitManager
{
    /// <summary>The name of the manager.</summary>
    public const string ManagerName = "mission control";

    private static readonly TimeSpan Cycle = TimeSpan.FromMilliseconds(200);
    private static readonly TimeSpan StatusPeriod = TimeSpan.FromSeconds(1);

    private readonly MessageSubscriber<VehicleState> _vehicle;
    private readonly MessageSubscriber<HealthReport> _health;
    private readonly MessageSubscriber<TrackList> _tracks;
    private readonly MessageSubscriber<CommandAuthority> _authority;
    private readonly MessageSubscriber<ImagingStatus> _imaging;
    private readonly QueueReceiver<VehicleCommandResult> _answers;
    private readonly QueueReceiver<CameraObservation> _searchedGround;
    private readonly QueueSender<VehicleCommand> _commands;
    private readonly MessagePublisher<ImagingCommand> _imagingOrder;
    private readonly MessagePublisher<MissionStatus> _status;
    private readonly MissionFlight? _flight;
    private readonly MissionMachine? _machine;
    private readonly MissionAssessment _assessment = new();
    private TimeSpan? _lastStatus;
    private string? _abort; // any thread writes, this manager reads; replaced as a whole

    /// <summary>Makes the manager.</summary>
    /// <param name="options">Checked and read now; later changes have no effect.</param>
    /// <exception cref="ArgumentException">Options are out of their range, or the mission cannot be flown; the text names all faults.</exception>
    public MissionControlManager(MissionControlOptions options)
        : base(ManagerName)
    {
        MissionControlOptions copy = (options ?? throw new ArgumentNullException(nameof(options))).ValidatedCopy(nameof(options));
        _vehicle = Subscribe<VehicleState>(MessageNames.VehicleState);
        _health = Subscribe<HealthReport>(MessageNames.Health);
        _tracks = Subscribe<TrackList>(MessageNames.Tracks);
        _authority = Subscribe<CommandAuthority>(MessageNames.CommandAuthority);
        _imaging = Subscribe<ImagingStatus>(MessageNames.Imaging);
        _answers = Receive<VehicleCommandResult>(MessageNames.VehicleCommandResults);
        _searchedGround = Receive<CameraObservation>(MessageNames.SearchedGround, whenFull: QueueFullMode.DropOldest, wakeOnPush: false);
        _commands = Send<VehicleCommand>(MessageNames.VehicleCommands);
        _imagingOrder = Publish<ImagingCommand>(MessageNames.ImagingCommand);
        _status = Publish<MissionStatus>(MessageNames.Mission);
        WakeUpDelay = Cycle;
        if (copy.Mission is null)
            return;
        var desk = new CommandDispatcher(command => _commands.Push(command) != PushResult.Rejected, Log);
        _flight = new MissionFlight(copy.Mission, copy, desk, Log);
        _machine = new MissionMachine(_flight);
    }

    /// <summary>
    /// Gives the mission up: the vehicle comes home; before take-off it stays where it is. Comes back at once; does nothing when the
    /// mission is over or there is none. Only the first reason counts. Any thread.
    /// </summary>
    /// <param name="reason">Why, for people and the log.</param>
    public void Abort(string reason)
    {
        if (string.IsNullOrWhiteSpace(reason))
            throw new ArgumentException("An abort needs a reason.", nameof(reason));
        Interlocked.CompareExchange(ref _abort, reason, null);
        WakeUp();
    }

    /// <summary>
    /// Plans once as if home were in the area, and forgets it: the real plan, made in a unit of work when home is known, then finds its code
    /// compiled. On a small computer that alone takes longer than a manager may be away.
    /// </summary>
    protected override void Startup()
    {
        if (_flight is not null)
            FlightPlan.Make(_flight.Mission, _flight.Mission.Area[0], out _);
    }

    /// <inheritdoc/>
    protected override void ExecuteUnitOfWork()
    {
        MissionPhase before = _status.Value.Phase;
        if (_flight is not null && _machine is not null)
        {
            TakeIn(_flight);
            _assessment.Update(_flight);
            _machine.Tick(Volatile.Read(ref _abort));
            PostOrder(_flight, _machine);
        }
        else
        {
            DropUnread();
        }

        MissionPhase phase = _machine?.Phase ?? MissionPhase.NoMission;
        if (_lastStatus is null || phase != before || Now - _lastStatus.Value >= StatusPeriod)
            PostStatus(phase);
    }

    private void TakeIn(MissionFlight flight)
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
        while (_answers.TryPop(out VehicleCommandResult answer))
            flight.Desk.Take(answer, flight.Now);
        while (_searchedGround.TryPop(out CameraObservation look))
            flight.Route?.Mark(look);
        if (!_tracks.Fetch())
            return;
        flight.Tracks = _tracks.Value;
        if (flight.Plan is not null)
            flight.Looks.Note(flight);
    }

    private void DropUnread()
    {
        while (_answers.TryPop(out _))
        {
            // Nobody asked.
        }

        while (_searchedGround.TryPop(out _))
        {
            // There is no area.
        }
    }

    private void PostOrder(MissionFlight flight, MissionMachine machine)
    {
        bool searches = machine.Phase is MissionPhase.Searching or MissionPhase.Looking;
        ref ImagingCommand order = ref _imagingOrder.Value;
        ImagingMode mode = searches ? ImagingMode.Search : ImagingMode.Off;
        if (order.Mode == mode)
            return;
        order.Mode = mode;
        order.CameraPitchRadians = flight.Mission.CameraPitchRadians;
        order.CameraYawRadians = flight.Mission.CameraYawRadians;
        order.GroundAltitudeAmslMetres = flight.GroundAltitudeAmslMetres;
        order.Colours = flight.Mission.Targets;
        _imagingOrder.Post();
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
            status.Revisits = _flight.Looks.Done;
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
