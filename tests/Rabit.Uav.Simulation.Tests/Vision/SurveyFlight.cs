using System;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Simulation.Tests.Vision;

/// <summary>
/// Stands for vehicle and autopilot: flies lanes over a square, leaning this way and that, writes the truth for the
/// camera, and reports Image Processing the same truth as poses, 10 positions and 50 attitudes a second, 30 ms late.
/// </summary>
internal sealed class SurveyFlight : RabitManager
{
    private const double Speed = 6;
    private const double LaneLength = 70;
    private const double LaneSpacing = 18;
    private const int Late = 3;

    private readonly TruthHistory _truth;
    private readonly WorldFrame _frame;
    private readonly double _height;
    private readonly ImagingCommand _wanted;
    private readonly QueueSender<PoseSample> _poses;
    private readonly MessagePublisher<ImagingCommand> _order;
    private readonly MessagePublisher<OwnAddress> _address;
    private long _step;

    public SurveyFlight(TruthHistory truth, WorldFrame frame, double heightMetres, ImagingCommand order)
        : base("survey flight")
    {
        _truth = truth;
        _frame = frame;
        _height = heightMetres;
        _poses = Send<PoseSample>(MessageNames.Poses);
        _order = Publish<ImagingCommand>(MessageNames.ImagingCommand);
        _address = Publish<OwnAddress>(MessageNames.OwnAddress);
        _wanted = order;
        WakeUpDelay = TimeSpan.FromMilliseconds(10);
    }

    /// <summary>Where it is at a time.</summary>
    public TruePose PoseAt(TimeSpan time) => PoseAt((long)(time.TotalMilliseconds / 10));

    protected override void ExecuteUnitOfWork()
    {
        if (_step == 0)
        {
            _order.Value = _wanted;
            _order.Post();
            _address.Value = new OwnAddress { SystemId = 1, ComponentId = 191 };
            _address.Post();
        }

        _truth.Add(PoseAt(_step));
        long reported = _step - Late;
        if (reported >= 0 && reported % 2 == 0)
            Send(PoseAt(reported), hasPosition: reported % 10 == 0);
        _step++;
    }

    private void Send(in TruePose pose, bool hasPosition)
    {
        _poses.Push(new PoseSample
        {
            Kind = PoseSampleKind.Attitude,
            Time = pose.Time,
            Attitude = EulerAngles.FromRadians(
                pose.Attitude.Roll.Radians, pose.Attitude.Pitch.Radians,
                Math.IEEERemainder(pose.Attitude.Yaw.Radians, 2 * Math.PI)),
        });
        if (hasPosition)
        {
            _poses.Push(new PoseSample
            {
                Kind = PoseSampleKind.Position,
                Time = pose.Time,
                Position = _frame.ToPlace(pose.Position - NedPosition.Origin),
                VelocityNed = pose.VelocityNed,
            });
        }
    }

    // Up one lane and down the next; the turn is done on the spot within a second, as far as the camera sees.
    private TruePose PoseAt(long step)
    {
        double t = step * 0.01;
        double along = Speed * t;
        int lane = (int)(along / LaneLength);
        double onLane = along - (lane * LaneLength);
        bool isNorthward = lane % 2 == 0;
        return new TruePose
        {
            Time = TimeSpan.FromMilliseconds(step * 10),
            Position = new NedPosition(isNorthward ? onLane : LaneLength - onLane, lane * LaneSpacing, -_height),
            VelocityNed = new NedVector(isNorthward ? Speed : -Speed, 0, 0),
            Attitude = EulerAngles.FromRadians(
                0.12 * Math.Sin(0.9 * t),
                -0.08 + (0.06 * Math.Sin(0.7 * t)),
                (isNorthward ? 0 : Math.PI) + (0.2 * Math.Sin(0.3 * t))),
            CameraPitch = _wanted.CameraPitch,
        };
    }
}
