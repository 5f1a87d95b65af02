using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>
/// The best pictures of each track, kept while the manager still has them: the manager forgets the oldest, and on a
/// long flight the best ones of a track may be long gone at the end. One thread at a time.
/// </summary>
internal sealed class TrackPictures(
    Func<IReadOnlyList<ImageChip>> imageChips, Func<long, PictureOverview?>? findOverview = null)
{
    /// <summary>
    /// Of so many tracks that are not confirmed: of one that is confirmed later, where there are more, those that the
    /// manager still has then. Clutter makes thousands of them.
    /// </summary>
    public const int MaxTentative = 100;

    private readonly Dictionary<int, Kept> _kept = [];   // by the id of the track

    /// <summary>Asks for image chips only when the best pictures of a track have become others.</summary>
    public void Take(TrackList tracks)
    {
        ForgetGone(tracks);
        int tentative = _kept.Values.Count(k => !k.WasConfirmed);
        IReadOnlyList<ImageChip>? chips = null;
        foreach (TargetTrack track in tracks.Tracks)
        {
            if (track.BestPictureNumber < 0)
                continue;
            bool isTentative = track.State == TrackState.Tentative;
            if (!_kept.TryGetValue(track.Id, out Kept? kept))
            {
                if (isTentative && ++tentative > MaxTentative)
                    continue;
                _kept[track.Id] = kept = new Kept();
            }

            kept.WasConfirmed |= !isTentative;
            if (!kept.Wants(track))
                continue;
            chips ??= imageChips();
            kept.Take(track, chips, findOverview);
        }
    }

    /// <summary>Those of all tracks, also of the lost ones.</summary>
    public IReadOnlyList<ImageChip> ToArray() => _kept.Values.SelectMany(k => k.Chips).ToArray();

    /// <summary>The whole picture of the best report of each track.</summary>
    public IReadOnlyList<PictureOverview> OverviewsToArray()
        => _kept.Values.Select(k => k.Overview).OfType<PictureOverview>().ToArray();

    // What was never confirmed and is gone was clutter.
    private void ForgetGone(TrackList tracks)
    {
        if (_kept.Count <= tracks.Tracks.Length)
            return;
        var there = new HashSet<int>(tracks.Tracks.Select(t => t.Id));
        int[] gone = _kept.Where(k => !k.Value.WasConfirmed && !there.Contains(k.Key)).Select(k => k.Key).ToArray();
        foreach (int id in gone)
            _kept.Remove(id);
    }

    private sealed class Kept
    {
        private TrackPicture[] _wanted = [];
        private List<ImageChip> _chips = [];

        public IReadOnlyList<ImageChip> Chips => _chips;

        public PictureOverview? Overview { get; private set; }

        public bool WasConfirmed { get; set; }

        public bool Wants(TargetTrack track) => !PicturesOf(track).SequenceEqual(_wanted);

        public void Take(
            TargetTrack track, IReadOnlyList<ImageChip> chips, Func<long, PictureOverview?>? findOverview)
        {
            bool isNewBest = _wanted.Length == 0 || _wanted[0].PictureNumber != track.BestPictureNumber;
            _wanted = PicturesOf(track).ToArray();
            _chips = _wanted.Select(w => Find(chips, w) ?? Find(_chips, w)).OfType<ImageChip>().ToList();
            if (isNewBest)
                Overview = findOverview?.Invoke(track.BestPictureNumber) ?? Overview;
        }

        private static IEnumerable<TrackPicture> PicturesOf(TargetTrack track)
        {
            yield return new TrackPicture(track.BestPictureNumber, track.BestReportIndex);
            foreach (TrackPicture other in track.OtherPictures)
                yield return other;
        }

        private static ImageChip? Find(IReadOnlyList<ImageChip> chips, TrackPicture wanted)
            => chips.FirstOrDefault(c => c.PictureNumber == wanted.PictureNumber
                && c.ReportIndex == wanted.ReportIndex);
    }
}
