using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;

namespace Rabit.Uav.MissionControl;

// How the heights come about: the ground, raised where it is too steep, and the highest within the distance of a goal.
internal sealed partial class TerrainFollowing
{
    // Each node has the highest ground of the four cells around it: between nodes the ground is below what they give.
    private string? Sample()
    {
        for (int i = 0; i < _rise.Length; i++)
            _rise[i] = float.NegativeInfinity;
        bool isFine = PostMetres() < CellMetres;
        double[] norths = Lines(_southWest.North, _rows, isFine ? [] : PostsToTheNorth());
        double[] easts = Lines(_southWest.East, _columns, isFine ? [] : PostsToTheEast());
        foreach (double north in norths)
        {
            foreach (double east in easts)
            {
                var at = new PlanePoint(north, east);
                double ground = GroundMetres(at);
                if (double.IsNaN(ground))
                    return FaultAt(at);
                Raise(at, ground);
            }
        }

        return isFine ? SamplePosts() : null;
    }

    // Between the lines of nodes and of posts the ground is bilinear: its highest place is where two of them cross.
    private double[] Lines(double first, int count, IEnumerable<double> posts)
        => Enumerable.Range(0, count).Select(i => first + (i * CellMetres))
            .Concat(posts.Where(p => p > first && p < first + ((count - 1) * CellMetres))).ToArray();

    private IEnumerable<double> PostsToTheNorth() => Enumerable.Range(0, _terrain.Rows).Select(row =>
        ToNed(_terrain.SouthWest.Latitude + (row * _terrain.LatitudeStep), _frame.Origin.Longitude).North);

    private IEnumerable<double> PostsToTheEast() => Enumerable.Range(0, _terrain.Columns).Select(column =>
        ToNed(_frame.Origin.Latitude, _terrain.SouthWest.Longitude + (column * _terrain.LongitudeStep)).East);

    private NedPosition ToNed(Angle latitude, Angle longitude)
        => _frame.ToNed(new GeodeticPosition(new GeographicPoint(latitude, longitude), _frame.Origin.Altitude));

    // Where many posts lie in a cell: the highest of them.
    private string? SamplePosts()
    {
        for (int row = 0; row < _rows - 1; row++)
        {
            for (int column = 0; column < _columns - 1; column++)
            {
                TerrainLookup found = _terrain.TryMaxAltitude(
                    PointAt(NodeAt(row, column)), PointAt(NodeAt(row + 1, column + 1)), out AmslAltitude highest);
                if (found != TerrainLookup.Known)
                    return FaultAt(NodeAt(row, column));
                Raise(row, row + 1, column, column + 1, highest.Metres - _homeAmslMetres);
            }
        }

        return null;
    }

    private void Raise(PlanePoint at, double ground)
    {
        const double Rounding = 1e-6;
        PlanePoint cells = (1 / CellMetres) * (at - _southWest);
        Raise(
            (int)Math.Ceiling(cells.North - Rounding) - 1, (int)Math.Floor(cells.North + Rounding) + 1,
            (int)Math.Ceiling(cells.East - Rounding) - 1, (int)Math.Floor(cells.East + Rounding) + 1, ground);
    }

    private void Raise(int south, int north, int west, int east, double ground)
    {
        for (int row = Math.Max(0, south); row <= Math.Min(_rows - 1, north); row++)
        {
            for (int column = Math.Max(0, west); column <= Math.Min(_columns - 1, east); column++)
            {
                ref float rise = ref _rise[(row * _columns) + column];
                rise = Math.Max(rise, (float)ground);
            }
        }
    }

    private double PostMetres()
        => MetresPerDegree * Math.Min(
            _terrain.LatitudeStep.Degrees, _terrain.LongitudeStep.Degrees * Trig.Cos(_frame.Origin.Latitude.Radians));

    private string FaultAt(PlanePoint at)
    {
        GeographicPoint point = PointAt(at);
        string what = TextOf(_terrain.TryAltitude(point, out _));
        return $"the terrain grid {what} {MissionNumbers.Of(at)} from home "
            + $"({point}); it must cover the fence and home";
    }

    // A chamfer: from each node down the slope to its neighbours, in the order of reading and back.
    private void LimitSlope()
    {
        float straight = (float)(MaxSlope * CellMetres);
        float diagonal = (float)(MaxSlope * CellMetres * Math.Sqrt(2));
        for (int row = 0; row < _rows; row++)
        {
            for (int column = 0; column < _columns; column++)
            {
                ref float rise = ref _rise[(row * _columns) + column];
                rise = Math.Max(rise, Near(row, column - 1) - straight);
                rise = Math.Max(rise, Near(row - 1, column) - straight);
                rise = Math.Max(rise, Near(row - 1, column - 1) - diagonal);
                rise = Math.Max(rise, Near(row - 1, column + 1) - diagonal);
            }
        }

        for (int row = _rows - 1; row >= 0; row--)
        {
            for (int column = _columns - 1; column >= 0; column--)
            {
                ref float rise = ref _rise[(row * _columns) + column];
                rise = Math.Max(rise, Near(row, column + 1) - straight);
                rise = Math.Max(rise, Near(row + 1, column) - straight);
                rise = Math.Max(rise, Near(row + 1, column + 1) - diagonal);
                rise = Math.Max(rise, Near(row + 1, column - 1) - diagonal);
            }
        }
    }

    private float Near(int row, int column)
        => row < 0 || column < 0 || row >= _rows || column >= _columns
            ? float.NegativeInfinity
            : _rise[(row * _columns) + column];

    // The highest node within the distance of a goal: of the rows first, then of the columns.
    private void LookAhead()
    {
        int reach = (int)Math.Ceiling(PathFollower.MaxGoalMetres(MaxSpeedMetresPerSecond) / CellMetres);
        var ofRows = new float[_rise.Length];
        for (int i = 0; i < _rise.Length; i++)
        {
            int start = i / _columns * _columns;
            int last = Math.Min(start + _columns - 1, i + reach);
            float highest = _rise[i];
            for (int j = Math.Max(start, i - reach); j <= last; j++)
                highest = Math.Max(highest, _rise[j]);
            ofRows[i] = highest;
        }

        for (int i = 0; i < _rise.Length; i++)
        {
            float highest = ofRows[i];
            int last = Math.Min(_rise.Length - 1, i + (reach * _columns));
            for (int j = Math.Max(i % _columns, i - (reach * _columns)); j <= last; j += _columns)
                highest = Math.Max(highest, ofRows[j]);
            _ahead[i] = highest;
        }
    }
}
