using System;
using System.Linq;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Reporting.Tests.Recording;

/// <summary>The best pictures of tracks are kept; those of clutter are not.</summary>
public sealed class TrackPicturesTests
{
    [Fact]
    public void Take_TrackWasConfirmedAndIsGone_ItsPictureStays()
    {
        TrackPictures pictures = Open();
        pictures.Take(List(Track(1, TrackState.Confirmed), Track(2, TrackState.Tentative)));
        pictures.Take(List());

        Assert.Equal([1], pictures.OverviewsToArray().Select(o => o.PictureNumber));
    }

    [Fact]
    public void Take_ManyTentativeTracks_SomeAreKeptWhileTheyAreThere()
    {
        TrackPictures pictures = Open();
        TargetTrack[] clutter =
            [.. Enumerable.Range(1, 3 * TrackPictures.MaxTentative).Select(i => Track(i, TrackState.Tentative))];
        for (int i = 0; i < 3; i++)
            pictures.Take(List(clutter));
        Assert.Equal(TrackPictures.MaxTentative, pictures.OverviewsToArray().Count);

        TargetTrack found = Track(clutter.Length, TrackState.Confirmed);
        pictures.Take(List([.. clutter.Take(clutter.Length - 1), found]));
        Assert.Contains(pictures.OverviewsToArray(), o => o.PictureNumber == found.Id);

        pictures.Take(List(found));
        Assert.Equal([found.Id], pictures.OverviewsToArray().Select(o => (int)o.PictureNumber));
    }

    private static TrackPictures Open()
        => new(() => [], number => new PictureOverview(number, 1, 1, new byte[3], []));

    private static TrackList List(params TargetTrack[] tracks) => new(TimeSpan.Zero, tracks);

    private static TargetTrack Track(int id, TrackState state)
        => new() { Id = id, State = state, BestPictureNumber = id };
}
