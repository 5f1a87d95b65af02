using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Web.State;

/// <summary>
/// The tracks with their ellipses, each in a slot of its own, which the next one takes over; and the pictures of them,
/// which browsers fetch one by one.
/// </summary>
/// <param name="prefix">Of the vehicle.</param>
/// <param name="pictures">Keeps the pictures.</param>
/// <param name="imageChips">Returns the newest image chips; null for none.</param>
internal sealed class TrackItems(string prefix, PageChips pictures, Func<IReadOnlyList<ImageChip>>? imageChips)
{
    /// <summary>The newest ones where there are more.</summary>
    public const int MaxTracks = 200;

    private readonly Dictionary<int, int> _slots = [];   // by track
    private readonly SortedSet<int> _free = [.. Enumerable.Range(0, MaxTracks)];
    private TrackList? _last;

    public void Write(ItemWriter writer, PageState state, TrackList tracks)
    {
        if (ReferenceEquals(tracks, _last))
            return;
        _last = tracks;
        TargetTrack[] shown = [.. tracks.Tracks.Skip(Math.Max(0, tracks.Tracks.Length - MaxTracks))];
        foreach (int gone in _slots.Keys.Except(shown.Select(t => t.Id)).ToArray())
        {
            state.Remove(KeyOf(_slots[gone]));
            _free.Add(_slots[gone]);
            _slots.Remove(gone);
            pictures.Forget(gone);
        }

        IReadOnlyList<ImageChip> chips = imageChips?.Invoke() ?? [];
        foreach (TargetTrack track in shown)
            Write(writer, track, pictures.Take(track, chips));
    }

    private void Write(ItemWriter writer, TargetTrack track, long picture)
    {
        if (!_slots.TryGetValue(track.Id, out int slot))
        {
            slot = _free.Min;
            _free.Remove(slot);
            _slots.Add(track.Id, slot);
        }

        writer.Object(KeyOf(slot)).Count("id", track.Id)
            .Text("class", track.Class.IsNone ? "no class" : track.Class.ToString())
            .Text("state", track.State.ToString())
            .Text("decision", track.Decision == TargetDecision.None ? null : track.Decision.ToString())
            .Number("lat", track.Position.Latitude.Degrees, 7).Number("lon", track.Position.Longitude.Degrees, 7)
            .Number("major", track.Covariance.HalfMajorAxis95Metres, 1)
            .Number("minor", track.Covariance.HalfMinorAxis95Metres, 1)
            .Number("axis", track.Covariance.MajorAxis.Degrees, 0).Count("reports", track.Reports)
            .Number("seen", track.LastSeen.TotalSeconds, 0).Number("first", track.FirstSeen.TotalSeconds, 0)
            .Count("picture", picture).End();
    }

    private string KeyOf(int slot) => string.Create(CultureInfo.InvariantCulture, $"{prefix}/track/{slot}");
}
