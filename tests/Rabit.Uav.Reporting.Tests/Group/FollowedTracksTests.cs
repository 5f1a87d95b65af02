using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Reporting.Tests.Group;

/// <summary>Which track is the target that a group follows.</summary>
public sealed class FollowedTracksTests
{
    private static readonly LocalNedFrame Frame
        = LocalNedFrame.IgnoringGeoid(GeodeticPosition.FromDegrees(47.39697, 8.54426, 488));

    // To the east, and to the north 60 m beside its start.
    [Fact]
    public void Take_TwoOfOneClass_IsTheOneThatIsWhereTheTaskSays()
    {
        var followed = new FollowedTracks();
        for (int second = 0; second < 30; second++)
        {
            var tracks = new TrackList(
                Seconds(second), [Track(1, 0, 4 * second, 4, second), Track(2, 60, 0, 0, second)]);
            followed.Take(tracks, Status(Task(1, 2, 4 * second, second)));
        }

        Assert.Equal([new FollowedTrack(3, 7, 1, 1)], followed.ToArray());
    }

    // They pass each other: for two seconds the other one is nearer.
    [Fact]
    public void Take_AnotherOneIsNearerForAMoment_IsNotNamed()
    {
        var followed = new FollowedTracks();
        for (int second = 0; second < 30; second++)
        {
            double passing = second is 14 or 15 ? 1 : 60;
            var tracks = new TrackList(
                Seconds(second), [Track(1, 3, 4 * second, 4, second), Track(2, passing, 4 * second, 0, second)]);
            followed.Take(tracks, Status(Task(1, 0, 4 * second, second)));
        }

        Assert.Equal([1], followed.ToArray().Select(f => f.TrackId));
    }

    // Lost, and found again as another track.
    [Fact]
    public void Take_TrackThatBeginsAgain_BothAreNamed()
    {
        var followed = new FollowedTracks();
        for (int second = 0; second < 30; second++)
        {
            int id = second < 12 ? 1 : 2;
            followed.Take(
                new TrackList(Seconds(second), [Track(id, 0, 4 * second, 4, second)]),
                Status(Task(1, 0, 4 * second, second)));
        }

        Assert.Equal([1, 2], followed.ToArray().Select(f => f.TrackId));
    }

    // What is known of the task is two seconds old, and the car goes on.
    [Fact]
    public void Take_TaskIsOlderThanTheTrack_ComparesThemAtOneTime()
    {
        var followed = new FollowedTracks();
        var tracks = new TrackList(Seconds(10), [Track(1, 0, 80, 8, 10), Track(2, 0, 60, 0, 10)]);
        followed.Take(tracks, Status(Task(1, 0, 64, 8)));

        Assert.Equal([1], followed.ToArray().Select(f => f.TrackId));
    }

    [Fact]
    public void Take_FarAwayOrOfAnotherTime_IsNone()
    {
        var followed = new FollowedTracks();
        followed.Take(new TrackList(Seconds(10), [Track(1, 0, 20, 0, 10)]), Status(Task(1, 0, 0, 10)));
        followed.Take(new TrackList(Seconds(20), [Track(1, 0, 0, 0, 10)]), Status(Task(1, 0, 0, 20)));

        Assert.Empty(followed.ToArray());
    }

    private static GroupStatus Status(FollowTask task) => new() { Followings = [task] };

    private static FollowTask Task(ushort number, double north, double east, double seconds) => new()
    {
        Finder = 3,
        Session = 7,
        Number = number,
        Class = DefaultTargetClasses.Red,
        Position = Frame.ToGeodetic(new NedPosition(north, east, 0)),
        Time = Seconds(seconds),
    };

    private static TargetTrack Track(int id, double north, double east, double eastwards, double seconds) => new()
    {
        Id = id,
        State = TrackState.Confirmed,
        Class = DefaultTargetClasses.Red,
        Motion = TargetMotion.Vehicle,
        Position = Frame.ToGeodetic(new NedPosition(north, east, 0)),
        VelocityNed = new NedVector(0, eastwards, 0),
        Time = Seconds(seconds),
    };

    private static TimeSpan Seconds(double seconds) => TimeSpan.FromSeconds(seconds);
}
