using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Globalization;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.Web.Collecting;

namespace Rabit.Uav.Web.State;

/// <summary>
/// The ground that the pictures have shown, in cells over the area of the mission, for the eye: what the mission counts
/// is in its status. A row of cells is a value of its own, so that a picture changes few.
/// </summary>
internal sealed class SeenCells(string prefix)
{
    private const int MaxSide = 96;

    private ImmutableArray<GeodeticPosition> _area;
    private LocalNedFrame _frame;
    private (double North, double East) _origin;   // the south-west corner
    private double _cellMetres;
    private bool[,] _isSeen = new bool[0, 0];
    private bool[] _hasChanged = [];
    private bool _isNew;
    private long _lastNumber = -1;

    public void Mark(FlightMoment moment)
    {
        if (moment.Mission.Plan is not { } plan || plan.Area.Length < 3)
            return;
        if (plan.Area != _area)
            Begin(plan);
        CameraObservation seen = moment.Imaging.LastObservation;
        if (moment.Imaging.Observations == 0 || seen.Number == _lastNumber)
            return;
        _lastNumber = seen.Number;
        GeodeticPosition[] corners = [seen.TopLeft, seen.TopRight, seen.BottomRight, seen.BottomLeft];
        if (corners.All(c => c.IsValid && (c.Latitude.Radians != 0 || c.Longitude.Radians != 0)))
            Mark([.. corners.Select(c => _frame.ToNed(c))]);
    }

    /// <summary>Writes the rows that have changed.</summary>
    public void Write(ItemWriter writer, PageState state)
    {
        if (_isNew)
            WriteFrame(writer, state);
        for (int row = 0; row < _hasChanged.Length; row++)
        {
            if (!_hasChanged[row])
                continue;
            _hasChanged[row] = false;
            writer.Object(KeyOf(row)).Text("seen", RowText(row)).End();
        }
    }

    private void Begin(SearchPlan plan)
    {
        _area = plan.Area;
        _frame = LocalNedFrame.IgnoringGeoid(plan.Home);
        NedPosition[] corners = [.. plan.Area.Select(c => _frame.ToNed(c))];
        _origin = (corners.Min(c => c.North), corners.Min(c => c.East));
        double height = corners.Max(c => c.North) - _origin.North;
        double width = corners.Max(c => c.East) - _origin.East;
        _cellMetres = Math.Max(1, Math.Max(height, width) / MaxSide);
        _isSeen = new bool[Cells(height), Cells(width)];
        _hasChanged = new bool[_isSeen.GetLength(0)];
        Array.Fill(_hasChanged, true);
        _isNew = true;
    }

    private int Cells(double metres) => Math.Clamp((int)Math.Ceiling(metres / _cellMetres), 1, MaxSide);

    private void WriteFrame(ItemWriter writer, PageState state)
    {
        _isNew = false;
        GeodeticPosition south = _frame.ToGeodetic(new NedPosition(_origin.North, _origin.East, 0));
        GeodeticPosition north = _frame.ToGeodetic(new NedPosition(
            _origin.North + (_isSeen.GetLength(0) * _cellMetres),
            _origin.East + (_isSeen.GetLength(1) * _cellMetres), 0));
        writer.Object(prefix + "/seen").Number("south", south.Latitude.Degrees, 7)
            .Number("west", south.Longitude.Degrees, 7)
            .Number("north", north.Latitude.Degrees, 7).Number("east", north.Longitude.Degrees, 7)
            .Count("rows", _isSeen.GetLength(0)).Count("columns", _isSeen.GetLength(1)).End();
        for (int row = _isSeen.GetLength(0); row < MaxSide; row++)
            state.Remove(KeyOf(row));
    }

    // Cells whose centre is in the convex quadrangle.
    private void Mark(NedPosition[] corners)
    {
        int first = Math.Max(0, (int)((corners.Min(c => c.North) - _origin.North) / _cellMetres));
        int last = Math.Min(
            _isSeen.GetLength(0) - 1, (int)((corners.Max(c => c.North) - _origin.North) / _cellMetres));
        for (int row = first; row <= last; row++)
        {
            for (int column = 0; column < _isSeen.GetLength(1); column++)
            {
                double east = _origin.East + ((column + 0.5) * _cellMetres);
                if (_isSeen[row, column] || !Contains(corners, CentreOf(row), east))
                    continue;
                _isSeen[row, column] = true;
                _hasChanged[row] = true;
            }
        }
    }

    private double CentreOf(int row) => _origin.North + ((row + 0.5) * _cellMetres);

    private static bool Contains(NedPosition[] corners, double north, double east)
    {
        bool isLeft = false;
        bool isRight = false;
        for (int i = 0; i < corners.Length; i++)
        {
            NedPosition a = corners[i];
            NedPosition b = corners[(i + 1) % corners.Length];
            double side = ((b.North - a.North) * (east - a.East)) - ((b.East - a.East) * (north - a.North));
            isLeft |= side > 0;
            isRight |= side < 0;
        }

        return !(isLeft && isRight);
    }

    private string KeyOf(int row) => string.Create(CultureInfo.InvariantCulture, $"{prefix}/seen/{row}");

    // Four cells a hexadecimal digit, from the west.
    private string RowText(int row)
    {
        int columns = _isSeen.GetLength(1);
        return string.Create((columns + 3) / 4, (Row: row, Columns: columns), (digits, range) =>
        {
            for (int digit = 0; digit < digits.Length; digit++)
            {
                int value = 0;
                for (int bit = 0; bit < 4; bit++)
                {
                    int column = (digit * 4) + bit;
                    value = (value << 1) | (column < range.Columns && _isSeen[range.Row, column] ? 1 : 0);
                }

                digits[digit] = "0123456789abcdef"[value];
            }
        });
    }
}
