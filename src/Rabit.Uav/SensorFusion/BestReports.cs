using System.Collections.Immutable;
using Rabit.Uav.Messages;

namespace Rabit.Uav.SensorFusion;

/// <summary>
/// The three reports with the best scores of those that were added; of equal ones the first. A changing value: keep it
/// in a field.
/// </summary>
internal struct BestReports
{
    private Entry _first;
    private Entry _second;
    private Entry _third;
    private int _count;
    private ImmutableArray<TrackPicture> _others;   // made again when they change

    /// <summary>The picture of the best one; -1 where there is none.</summary>
    public readonly long PictureNumber => _count > 0 ? _first.Picture.PictureNumber : -1;

    /// <summary>Which report of that picture.</summary>
    public readonly int ReportIndex => _count > 0 ? _first.Picture.ReportIndex : 0;

    /// <summary>The second and the third, as far as there are.</summary>
    public ImmutableArray<TrackPicture> Others
    {
        get
        {
            if (_others.IsDefault)
            {
                _others = _count switch
                {
                    <= 1 => [],
                    2 => [_second.Picture],
                    _ => [_second.Picture, _third.Picture],
                };
            }

            return _others;
        }
    }

    public void Add(double score, TrackPicture picture)
    {
        // One that is no number is not better than any.
        if (!(score > double.NegativeInfinity))
            return;
        var entry = new Entry(score, picture);
        if (_count == 0 || score > _first.Score)
            (_first, _second, _third) = (entry, _first, _second);
        else if (_count == 1 || score > _second.Score)
            (_second, _third) = (entry, _second);
        else if (_count == 2 || score > _third.Score)
            _third = entry;
        else
            return;
        _count = _count < 3 ? _count + 1 : 3;
        _others = default;
    }

    /// <summary>Adds those of another track of the same target.</summary>
    public void Add(in BestReports other)
    {
        if (other._count > 0)
            Add(other._first.Score, other._first.Picture);
        if (other._count > 1)
            Add(other._second.Score, other._second.Picture);
        if (other._count > 2)
            Add(other._third.Score, other._third.Picture);
    }

    private readonly struct Entry(double score, TrackPicture picture)
    {
        public double Score { get; } = score;

        public TrackPicture Picture { get; } = picture;
    }
}
