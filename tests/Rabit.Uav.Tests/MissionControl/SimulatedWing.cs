using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;
using Rabit.Uav.Tests.AutopilotInterface;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>
/// A fixed wing of either make, as frames: constant airspeed, a bounded turn rate, circles about its target, wind. It
/// stands in for Communications, Image Processing, Sensor Fusion and Health Monitoring, too. The pilot takes off and
/// changes modes.
/// </summary>
internal sealed class SimulatedWing : RabitManager
{
    public const uint Px4Loiter = 0x0304_0000;
    public const uint Px4Return = 0x0504_0000;

    private const double Step = 0.05;
    private const double Gravity = 9.81;
    private const double MaxBank = 45 * Math.PI / 180;
    private const double MaxClimb = 2.5;

    // Banked, the camera sees other ground, radians per second.
    private const double MaxTurnOfPicture = 0.05;

    // Recorded: circles of 87 to 95 m for 80.
    private const double WiderBy = 1.1;
    private const double OwnRadius = 80;

    private readonly LocalNedFrame _frame;
    private readonly QueueReceiver<OutgoingFrame> _frames;
    private readonly QueueSender<LinkFrame> _link;
    private readonly QueueSender<CameraObservation> _searched;
    private readonly MessagePublisher<HealthReport> _health;
    private readonly MessagePublisher<ImagingStatus> _imaging;
    private readonly MessagePublisher<TrackList> _tracks;
    private readonly QueueReceiver<PoseSample> _poses;
    private readonly List<(TimeSpan Time, CommandInt Place)> _places = [];
    private readonly List<(TimeSpan Time, uint Mode)> _modeCommands = [];
    private TimeSpan _nextBeat;
    private TimeSpan _nextTelemetry;
    private TimeSpan _nextPicture;
    private (double North, double East) _centre;
    private double _radius = OwnRadius;
    private double _targetHeight;
    private double _course;
    private double _climb;
    private bool _isStraight;
    private double _vn;
    private double _ve;
    private uint _mode;
    private long _index;

    public SimulatedWing(MavAutopilot make, GeodeticPosition home)
        : base("wing")
    {
        Make = make;
        _frame = LocalNedFrame.IgnoringGeoid(home);
        _mode = make == MavAutopilot.Px4 ? 0x0001_0000u : (uint)PlaneMode.FlyByWireA;
        _frames = Receive<OutgoingFrame>(MessageNames.OutgoingFrames, 1000);
        _link = Send<LinkFrame>(MessageNames.AutopilotFrames);
        _searched = Send<CameraObservation>(MessageNames.SearchedGround);
        _health = Publish<HealthReport>(MessageNames.Health);
        _imaging = Publish<ImagingStatus>(MessageNames.Imaging);
        _tracks = Publish(MessageNames.Tracks, TrackList.None);
        _poses = Receive<PoseSample>(MessageNames.Poses, 1000, QueueFullMode.DropOldest);
        WakeUpDelay = TimeSpan.FromSeconds(Step);
    }

    public MavAutopilot Make { get; }

    public MavType Type { get; set; } = MavType.FixedWing;

    public double North { get; private set; }

    public double East { get; private set; }

    public double Height { get; private set; }

    public double Airspeed { get; set; } = 20;

    public (double North, double East) Wind { get; set; }

    public bool IsArmed { get; private set; }

    /// <summary>Whether frames go either way.</summary>
    public bool HasLink { get; set; } = true;

    /// <summary>Loses so many of the next answers to DO_REPOSITION.</summary>
    public int AnswersToLose { get; set; }

    /// <summary>What it answers to DO_REPOSITION where it does not obey; null obeys.</summary>
    public MavResult? RefusesPlaces { get; set; }

    /// <summary>It acknowledges places and does not fly to them.</summary>
    public bool IgnoresPlaces { get; set; }

    /// <summary>Whether commands of any kind came that are the pilot's.</summary>
    public List<MavCmd> Others { get; } = [];

    public List<(double North, double East, double Height)> Path { get; } = [];

    /// <summary>Each DO_REPOSITION that came over the link.</summary>
    public IReadOnlyList<(TimeSpan Time, CommandInt Place)> Places => _places;

    public IReadOnlyList<(TimeSpan Time, uint Mode)> ModeCommands => _modeCommands;

    public uint Mode => _mode;

    private uint GivenMode => Make == MavAutopilot.Px4 ? Px4Loiter : (uint)PlaneMode.Guided;

    private uint ReturnMode => Make == MavAutopilot.Px4 ? Px4Return : (uint)PlaneMode.Rtl;

    private bool IsFlying => Height > 0.5;

    /// <summary>The pilot takes off, to a circle near home.</summary>
    public void TakeOff(double height)
    {
        IsArmed = true;
        (_centre, _targetHeight, _radius) = ((0, 0), height, OwnRadius);
        Height = 1;
    }

    /// <summary>The pilot's switch.</summary>
    public void SetMode(uint mode)
    {
        _mode = mode;
        Enter();
        _nextBeat = TimeSpan.Zero;
    }

    /// <summary>The pilot gives it over.</summary>
    public void GiveOver() => SetMode(GivenMode);

    /// <summary>Another commander's place: no mode changes.</summary>
    public void SendElsewhere(double north, double east) => _centre = (north, east);

    /// <summary>The pilot lands it where he likes.</summary>
    public void Land(double north, double east)
    {
        (North, East, Height, _vn, _ve, _climb) = (north, east, 0, 0, 0, 0);
        IsArmed = false;
        _nextBeat = TimeSpan.Zero;
    }

    protected override void ExecuteUnitOfWork()
    {
        while (_poses.TryPop(out _))
        {
        }

        Listen();
        if (IsArmed && IsFlying)
            Fly();
        Path.Add((North, East, Height));
        TakePicture();
        if (Now >= _nextBeat)
        {
            _nextBeat = Now + TimeSpan.FromSeconds(1);
            Beat();
            PostOthers();
        }

        if (Now < _nextTelemetry)
            return;
        _nextTelemetry = Now + TimeSpan.FromSeconds(0.2);
        Report();
    }

    private void Fly()
    {
        (double n, double e) = (North - _centre.North, East - _centre.East);
        double distance = Math.Sqrt((n * n) + (e * e));
        double radius = _radius * WiderBy;
        double around = Math.Atan2(e, n) + (Math.PI / 2);
        double wanted = around + Math.Atan(2 * (distance - radius) / radius);
        double maxTurn = Gravity * Math.Tan(MaxBank) / Airspeed * Step;
        double turn = Math.Max(-maxTurn, Math.Min(maxTurn, Math.IEEERemainder(wanted - _course, 2 * Math.PI)));
        _isStraight = Math.Abs(turn) < MaxTurnOfPicture * Step;
        _course += turn;

        // The course is over ground: the autopilot crabs.
        double along = (Wind.North * Math.Cos(_course)) + (Wind.East * Math.Sin(_course));
        double across = (Wind.East * Math.Cos(_course)) - (Wind.North * Math.Sin(_course));
        double speed = along + Math.Sqrt((Airspeed * Airspeed) - (across * across));
        (_vn, _ve) = (speed * Math.Cos(_course), speed * Math.Sin(_course));
        _climb = Math.Max(-MaxClimb, Math.Min(MaxClimb, _targetHeight - Height));
        (North, East, Height) = (North + (_vn * Step), East + (_ve * Step), Height + (_climb * Step));
    }

    private void Enter()
    {
        if (_mode == ReturnMode)
            (_centre, _radius) = ((0, 0), OwnRadius);
        else
            (_centre, _radius, _targetHeight) = ((North, East), OwnRadius, Height);
    }

    private void Listen()
    {
        while (_frames.TryPop(out OutgoingFrame outgoing))
        {
            if (!HasLink || ScriptedAutopilot.CommandOf(outgoing.Frame) is not { } command)
                continue;
            switch (command)
            {
                case MavCmd.RequestMessage:
                    Answer(command, MavResult.Accepted);
                    Beat();
                    break;
                case MavCmd.DoSetMode:
                    TakeMode(OutgoingSink.Decode<CommandLong>(outgoing.Frame));
                    break;
                case MavCmd.DoReposition:
                    TakePlace(OutgoingSink.Decode<CommandInt>(outgoing.Frame));
                    break;
                default:
                    Others.Add(command);
                    Answer(command, MavResult.Accepted);
                    break;
            }
        }
    }

    private void TakeMode(in CommandLong command)
    {
        uint mode = Make == MavAutopilot.Px4
            ? ((uint)command.Param2 << 16) | ((uint)command.Param3 << 24)
            : (uint)command.Param2;
        _modeCommands.Add((Now, mode));
        _mode = mode;
        Enter();
        Answer(MavCmd.DoSetMode, MavResult.Accepted);
        Beat();
    }

    // ArduPilot refuses it outside GUIDED without the flag; PX4 takes the mode by the flag.
    private void TakePlace(in CommandInt place)
    {
        _places.Add((Now, place));
        MavResult? result = RefusesPlaces ?? (_mode == GivenMode || place.Param2 > 0 ? null : MavResult.Failed);
        if (result is null && !IgnoresPlaces)
        {
            _mode = GivenMode;
            double amsl = place.Frame == MavFrame.Global ? place.Z : _frame.Origin.AltitudeAmslMetres + place.Z;
            NedPosition to = _frame.ToNed(GeodeticPosition.FromDegrees(place.X / 1e7, place.Y / 1e7, amsl));
            _centre = (to.North, to.East);
            (_targetHeight, _radius) = (-to.Down, place.Param3 > 0 ? place.Param3 : OwnRadius);
        }

        if (AnswersToLose > 0)
            AnswersToLose--;
        else
            Answer(MavCmd.DoReposition, result ?? MavResult.Accepted);
    }

    private void Answer(MavCmd command, MavResult result)
        => Say(new CommandAck { Command = command, Result = result, TargetSystem = 1, TargetComponent = 191 });

    private void Beat() => Say(new Heartbeat
    {
        Type = Type,
        Autopilot = Make,
        BaseMode = MavModeFlag.CustomModeEnabled | (IsArmed ? MavModeFlag.SafetyArmed : 0),
        CustomMode = _mode,
        SystemStatus = MavState.Active,
        MavlinkVersion = 3,
    });

    private void Report()
    {
        var bootMs = (uint)(60_000 + Now.TotalMilliseconds);
        GeodeticPosition at = _frame.ToGeodetic(new NedPosition(North, East, -Height));
        Say(new GlobalPositionInt
        {
            TimeBootMs = bootMs,
            Lat = DegE7(at.Latitude),
            Lon = DegE7(at.Longitude),
            Alt = (int)(at.AltitudeAmslMetres * 1000),
            RelativeAlt = (int)(Height * 1000),
            Vx = (short)(_vn * 100),
            Vy = (short)(_ve * 100),
            Vz = (short)(-_climb * 100),
        });
        Say(new ExtendedSysState { LandedState = IsFlying ? MavLandedState.InAir : MavLandedState.OnGround });
        Say(new GpsRawInt { FixType = GpsFixType.Type3dFix, SatellitesVisible = 12, Eph = 80 });
        Say(new SysStatus { BatteryRemaining = 90, VoltageBattery = 16000 });
        GeodeticPosition target = _frame.ToGeodetic(new NedPosition(_centre.North, _centre.East, -_targetHeight));
        if (IsFlying)
        {
            Say(new PositionTargetGlobalInt
            {
                TimeBootMs = bootMs,
                LatInt = DegE7(target.Latitude),
                LonInt = DegE7(target.Longitude),
                Alt = (float)target.AltitudeAmslMetres,
                TypeMask = (PositionTargetTypemask)65016,
            });
        }
    }

    private static int DegE7(Angle angle) => (int)Math.Round(angle.Degrees * 1e7);

    private void Say<T>(T message)
        where T : struct, IMavlinkMessage
    {
        if (HasLink)
            _link.Push(AutopilotRig.FrameOf(message, Now, index: _index++));
    }

    private void PostOthers()
    {
        _health.Value = new HealthReport { Level = HealthLevel.Good };
        _health.Post();
        _imaging.Value = new ImagingStatus { HasCamera = true };
        _imaging.Post();
        _tracks.Post();
    }

    // 0.45 of the height ahead and behind, 0.6 to the sides, twice a second; flown in a straight line only.
    private void TakePicture()
    {
        if (!IsFlying || !_isStraight || Now < _nextPicture)
            return;
        _nextPicture = Now + TimeSpan.FromSeconds(0.5);
        _searched.Push(new CameraObservation
        {
            SourceSystemId = 1,
            Number = Path.Count,
            Time = Now,
            TopLeft = Corner(0.45, -0.6),
            TopRight = Corner(0.45, 0.6),
            BottomRight = Corner(-0.45, 0.6),
            BottomLeft = Corner(-0.45, -0.6),
        });
    }

    private GeodeticPosition Corner(double forward, double right)
    {
        double n = Height * ((forward * Math.Cos(_course)) - (right * Math.Sin(_course)));
        double e = Height * ((forward * Math.Sin(_course)) + (right * Math.Cos(_course)));
        return _frame.ToGeodetic(new NedPosition(North + n, East + e, 0));
    }
}
