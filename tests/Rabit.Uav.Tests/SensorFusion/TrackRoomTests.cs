using System;
using System.Linq;
using Rabit.Uav.Messages;
using Xunit;
using static Rabit.Uav.Tests.SensorFusion.FusionRig;

namespace Rabit.Uav.Tests.SensorFusion;

/// <summary>What becomes of tracks of standing targets where there is no room for more.</summary>
public sealed class TrackRoomTests
{
    [Fact]
    public void Tracks_NoRoom_IsCounted()
    {
        using var rig = new FusionRig(o => o.MaxTracks = 3);
        rig.Observe(0, 0, Enumerable.Range(0, 5).Select(i => Report(0, (10 * i) - 20)).ToArray());
        Assert.Equal(3, rig.Tracks.Count);
        Assert.Equal(2, rig.Counters.ReportsWithoutRoom);
    }

    // Four false alarms a second, each at another place, out of sight before they are missed.
    [Fact]
    public void Tracks_RoomIsFullOfClutter_TargetThatComesAfterItIsConfirmed()
    {
        using var rig = new FusionRig(o => o.MaxTracks = 20);
        for (int i = 0; i < 4; i++)
            rig.Observe(0, 0, Report(0, 0));
        int first = rig.Only.Id;
        for (int i = 0; i < 60; i++)
            rig.Observe(1000 + (40 * i), 0, Report(1000 + (40 * i), 0), Report(1000 + (40 * i), 12));
        for (int i = 0; i < 4; i++)
            rig.Observe(-500, 0, Report(-500, 0));

        Assert.Equal(0, rig.Counters.ReportsWithoutRoom);
        Assert.Equal(20, rig.Tracks.Count);
        int[] confirmed = rig.Tracks.Where(t => t.State == TrackState.Confirmed).Select(t => t.Id).ToArray();
        Assert.Equal(first, confirmed[0]);
        Assert.Equal(-500, PlaceOf(rig.Tracks.Single(t => t.Id == confirmed[1])).North, 0.5);
        Assert.Equal(2, confirmed.Length);
        Assert.Equal(102, rig.Counters.TracksDropped);
    }

    // The lost ones go only after those that were never confirmed; what is confirmed, or decided on, stays.
    [Fact]
    public void Tracks_RoomIsFull_LostOnesGoLastAndDecidedOnesNever()
    {
        using var rig = new FusionRig(o => o.MaxTracks = 3);
        for (int i = 0; i < 4; i++)
            rig.Observe(0, 0, Report(0, 0), Report(0, 10));
        for (int i = 0; i < 8; i++)
            rig.Observe(0, 0);
        Assert.All(rig.Tracks, t => Assert.Equal(TrackState.Lost, t.State));
        rig.Decide(rig.Tracks[0].Id, TargetDecision.Confirmed);
        rig.Observe(500, 0, Report(500, 0));
        Wait(rig);
        rig.Observe(600, 0, Report(600, 0));
        Assert.Equal(2, rig.Tracks.Count(t => t.State != TrackState.Tentative));
        Assert.Equal(600, PlaceOf(rig.Tracks[2]).North, 1);

        // That one was reported just now: of the two that come next one takes the place of the lost one.
        rig.Observe(700, 0, Report(700, 0), Report(700, 10));
        Assert.Equal(1, rig.Counters.ReportsWithoutRoom);
        Assert.Equal(TargetDecision.Confirmed, rig.Tracks[0].Decision);
        Assert.Equal([TrackState.Tentative, TrackState.Tentative], rig.Tracks.Skip(1).Select(t => t.State));
    }

    // They start no track, so that none has to go for them.
    [Fact]
    public void Tracks_RoomIsFullAndReportsAreTooLate_AllStay()
    {
        using var rig = new FusionRig(o => o.MaxTracks = 3);
        rig.Observe(0, 0, Report(0, -10), Report(0, 0), Report(0, 10));
        int[] before = [.. rig.Tracks.Select(t => t.Id)];
        rig.Run(30);
        TimeSpan then = rig.Now - TimeSpan.FromSeconds(15);
        rig.Push(Report(500, 0) with { SourceSystemId = 2, PictureNumber = 1, Time = then });
        rig.Run(2);
        Assert.Equal(before, rig.Tracks.Select(t => t.Id));
        Assert.Equal((1, 0), (rig.Counters.ReportsLate, rig.Counters.TracksDropped));
    }

    // One picture full of clutter is not to delete what was confirmed once.
    [Fact]
    public void Tracks_OnePictureFullOfClutter_DeletesNoMoreThanOneLostTrack()
    {
        using var rig = new FusionRig(o => o.MaxTracks = 6);
        for (int i = 0; i < 4; i++)
            rig.Observe(0, 0, Report(0, -10), Report(0, 0), Report(0, 10));
        for (int i = 0; i < 8; i++)
            rig.Observe(0, 0);
        Assert.Equal(3, rig.Tracks.Count(t => t.State == TrackState.Lost));
        rig.Observe(500, 0, Enumerable.Range(0, 20).Select(i => Report(500, (6 * i) - 60)).ToArray());
        Assert.Equal(2, rig.Tracks.Count(t => t.State == TrackState.Lost));
        Assert.Equal(6, rig.Tracks.Count);
        Assert.Equal(16, rig.Counters.ReportsWithoutRoom);
    }

    // So long that a track is not of now.
    private static void Wait(FusionRig rig)
    {
        for (int i = 0; i < 8; i++)
            rig.Observe(1000, 0);
    }
}
