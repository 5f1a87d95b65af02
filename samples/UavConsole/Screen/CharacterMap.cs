using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.Reporting;

namespace UavConsole;

/// <summary>
/// Draws a map in characters, north up: lines are dots (Braille patterns); home is H, a track the letter of its
/// colour, ? while it is tentative, x when it was lost; the vehicle is an arrow. The same model gives the same lines.
/// </summary>
internal sealed class CharacterMap
{
    private const string Arrows = "↑↗→↘↓↙←↖";
    private const string PlainArrows = "^^>vvv<^";
    private const double MinSideMetres = 20;
    private const int EllipseSteps = 48;
    private const int MinColumnsForScale = 20;
    private const int MinRowsForScale = 6;

    private readonly MapModel _model;
    private readonly int _columns;
    private readonly int _rows;
    private readonly bool _isUnicode;
    private readonly BrailleCanvas _canvas;
    private readonly char[][] _characters;
    private readonly MapInk[][] _inks;
    private double _west;
    private double _north;
    private double _metresPerDot;

    private CharacterMap(MapModel model, int columns, int rows, bool isUnicode)
    {
        (_model, _columns, _rows, _isUnicode) = (model, columns, rows, isUnicode);
        _canvas = new BrailleCanvas(columns, rows);
        _characters = Enumerable.Range(0, rows).Select(_ => new char[columns]).ToArray();
        _inks = Enumerable.Range(0, rows).Select(_ => new MapInk[columns]).ToArray();
    }

    /// <param name="model">What to show.</param>
    /// <param name="columns">Characters across, at least 1.</param>
    /// <param name="rows">Lines, at least 1.</param>
    /// <param name="isUnicode">Without it plain characters are enough for the terminal.</param>
    /// <param name="isAnnotated">
    /// Whether tracks have their numbers, and a scale and an arrow to the north are drawn.
    /// </param>
    public static MapPicture Draw(
        MapModel model, int columns, int rows, bool isUnicode = true, bool isAnnotated = false)
    {
        var map = new CharacterMap(model, Math.Max(1, columns), Math.Max(1, rows), isUnicode);
        map.Fit();
        map.DrawLines();
        map.TakeCanvas();
        map.DrawMarks();
        if (isAnnotated)
            map.DrawNumbers();
        if (isAnnotated && columns >= MinColumnsForScale && rows >= MinRowsForScale)
            map.DrawScale();
        return new MapPicture(map._characters, map._inks);
    }

    private void Fit()
    {
        IEnumerable<NedPosition> all = _model.Area.Concat(_model.Path).Concat(_model.Group.SelectMany(v => v.Path))
            .Concat(_model.Tracks.Where(t => t.Track.State != TrackState.Tentative).Select(t => t.Position));
        if (_model.Home is { } home)
            all = all.Append(home);
        NedPosition[] points = all.Where(IsUsable).ToArray();
        if (points.Length == 0)
            points = [default];
        (double west, double east) = Around(points.Min(p => p.East), points.Max(p => p.East));
        (double south, double north) = Around(points.Min(p => p.North), points.Max(p => p.North));

        // Dots are about square: a character is twice as high as wide.
        double across = Math.Max(1, (_columns * BrailleCanvas.DotsAcross) - 1);
        double down = Math.Max(1, (_rows * BrailleCanvas.DotsDown) - 1);
        _metresPerDot = Math.Max((east - west) / across, (north - south) / down);
        _west = ((west + east) / 2) - (across * _metresPerDot / 2);
        _north = ((north + south) / 2) + (down * _metresPerDot / 2);
    }

    private static (double Low, double High) Around(double low, double high)
    {
        double margin = Math.Max((high - low) * 0.03, (MinSideMetres - (high - low)) / 2);
        return (low - margin, high + margin);
    }

    private void DrawLines()
    {
        for (int index = 0; index + 1 < _model.Lanes.Count; index += 2)
            Line(_model.Lanes[index], _model.Lanes[index + 1], MapInk.Lane, every: 3);
        for (int index = 0; index < _model.Area.Count; index++)
            Line(_model.Area[index], _model.Area[(index + 1) % _model.Area.Count], MapInk.Area);
        foreach (IReadOnlyList<NedPosition> path in _model.Group.Select(v => v.Path).Append(_model.Path))
        {
            for (int index = 1; index < path.Count; index++)
                Line(path[index - 1], path[index], MapInk.Path);
        }

        foreach (MapTrack track in _model.Tracks.Where(t => t.Track.State == TrackState.Confirmed))
            DrawEllipse(track);
    }

    // Smaller than a character it would only blur the letter.
    private void DrawEllipse(MapTrack track)
    {
        HorizontalCovariance covariance = track.Track.Covariance;
        double major = covariance.HalfMajorAxis95Metres;
        double minor = covariance.HalfMinorAxis95Metres;
        if (!(major > _metresPerDot * BrailleCanvas.DotsDown) || !IsUsable(track.Position))
            return;
        (double cos, double sin) = (Math.Cos(covariance.MajorAxis.Radians), Math.Sin(covariance.MajorAxis.Radians));
        NedPosition Edge(int step)
        {
            double angle = 2 * Math.PI * step / EllipseSteps;
            (double along, double across) = (major * Math.Cos(angle), minor * Math.Sin(angle));
            return new NedPosition(
                track.Position.North + (along * cos) - (across * sin),
                track.Position.East + (along * sin) + (across * cos), 0);
        }

        for (int step = 0; step < EllipseSteps; step++)
            Line(Edge(step), Edge(step + 1), MapInk.Ellipse);
    }

    private void TakeCanvas()
    {
        for (int row = 0; row < _rows; row++)
        {
            for (int column = 0; column < _columns; column++)
            {
                _characters[row][column] = _canvas.CharacterAt(column, row, _isUnicode);
                _inks[row][column] = _canvas.InkAt(column, row);
            }
        }
    }

    private void DrawMarks()
    {
        if (_model.Home is { } home)
            Mark(home, 'H', MapInk.Home);
        foreach (MapTrack track in _model.Tracks.OrderBy(t => t.Track.State == TrackState.Confirmed))
            Mark(track.Position, LetterOf(track.Track), InkOf(track.Track));
        if (_model.Vehicle is { } place)
            Mark(place, Arrow(), MapInk.Vehicle);
        foreach (MapVehicle vehicle in _model.Group.Where(v => v.Path.Count > 0))
            Mark(vehicle.Path[vehicle.Path.Count - 1], vehicle.Mark, MapInk.Vehicle);
    }

    private void DrawNumbers()
    {
        foreach (MapTrack track in _model.Tracks.Where(t => t.Track.State != TrackState.Tentative))
        {
            string number = FlightText.Number(track.Track.Id);
            if (CellOf(track.Position) is { } cell && IsFree(cell.Column + 1, cell.Row, number.Length))
                Write(cell.Column + 1, cell.Row, number);
        }
    }

    private bool IsFree(int column, int row, int length)
        => column + length <= _columns
            && Enumerable.Range(column, length).All(c => _inks[row][c] < MapInk.Home);

    // In the corners below left, or right where something is left, and above right; a mark that stands there stays.
    private void DrawScale()
    {
        double metresPerColumn = _metresPerDot * BrailleCanvas.DotsAcross;
        double most = metresPerColumn * _columns / 4;
        double power = Math.Pow(10, Math.Floor(Math.Log10(most)));
        double metres = new[] { 5.0, 2.0, 1.0 }.Select(f => f * power).First(m => m <= most);
        int length = Math.Max(2, (int)Math.Round(metres / metresPerColumn));
        string bar = _isUnicode
            ? "├" + new string('─', length - 2) + "┤"
            : "|" + new string('-', length - 2) + "|";
        string text = $"{bar} {FlightText.Number(metres)} m";
        bool isLeftEmpty = _characters[_rows - 1].Take(text.Length).All(c => c == ' ');
        Write(isLeftEmpty ? 0 : Math.Max(0, _columns - text.Length), _rows - 1, text);
        Write(_columns - 1, 0, _isUnicode ? "▲" : "^");
        Write(_columns - 1, 1, "N");
    }

    private void Write(int column, int row, string text)
    {
        for (int index = 0; index < text.Length && column + index < _columns; index++)
        {
            if (_inks[row][column + index] >= MapInk.Home)
                continue;
            _characters[row][column + index] = text[index];
            _inks[row][column + index] = MapInk.Frame;
        }
    }

    private char Arrow()
    {
        string arrows = _isUnicode ? Arrows : PlainArrows;
        double eighths = _model.VehicleYawRadians / (Math.PI / 4);
        if (double.IsNaN(eighths) || Math.Abs(eighths) > 1e6)
            return '+';
        int index = (int)Math.Round(eighths) % arrows.Length;
        return arrows[index < 0 ? index + arrows.Length : index];
    }

    private static char LetterOf(TargetTrack track) => track.State switch
    {
        TrackState.Tentative => '?',
        TrackState.Lost or TrackState.Rejected => 'x',
        _ => TargetLetters.Letter(track.Class),
    };

    private static MapInk InkOf(TargetTrack track)
        => track.State == TrackState.Tentative ? MapInk.Tentative : TargetLetters.Ink(track.Class);

    private void Mark(NedPosition at, char character, MapInk ink)
    {
        if (CellOf(at) is not { } cell)
            return;
        _characters[cell.Row][cell.Column] = character;
        _inks[cell.Row][cell.Column] = ink;
    }

    // Null outside the map.
    private (int Column, int Row)? CellOf(NedPosition at)
    {
        if (!IsUsable(at))
            return null;
        (double x, double y) = ToDots(at);
        int column = (int)Math.Floor((Math.Round(x) + 0.5) / BrailleCanvas.DotsAcross);
        int row = (int)Math.Floor((Math.Round(y) + 0.5) / BrailleCanvas.DotsDown);
        return column < 0 || row < 0 || column >= _columns || row >= _rows ? null : (column, row);
    }

    private void Line(NedPosition from, NedPosition to, MapInk ink, int every = 1)
    {
        if (!IsUsable(from) || !IsUsable(to))
            return;
        (double x1, double y1) = ToDots(from);
        (double x2, double y2) = ToDots(to);
        _canvas.Line(x1, y1, x2, y2, ink, every);
    }

    private (double X, double Y) ToDots(NedPosition at)
        => ((at.East - _west) / _metresPerDot, (_north - at.North) / _metresPerDot);

    // What an autopilot says before it has a fix may be on the other side of the earth.
    private static bool IsUsable(NedPosition at) => Math.Abs(at.North) < 1e6 && Math.Abs(at.East) < 1e6;
}
