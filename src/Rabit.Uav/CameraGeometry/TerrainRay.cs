using System;
using Rabit.Geodesy;

namespace Rabit.Uav.CameraGeometry;

/// <summary>
/// Where a ray first intersects the terrain: over blocks of the grid that it is above at once, by their highest posts,
/// and cell by cell where it is not (traversal with a maximum pyramid; Tevs, Ihrke, Seidel, "Maximum Mipmaps for Fast,
/// Accurate, and Scalable Dynamic Height Field Rendering", 2008).
/// </summary>
internal static class TerrainRay
{
    private const double ToleranceMetres = 1e-5;

    // Beyond the border of a block, so that the next place is in the next one.
    private const double BeyondMetres = 1e-3;

    // Between two places so far apart the way over the grid is taken to be straight. A line of sight of so many metres
    // departs from that by 0.3 m, at high latitudes by some more; blocks have the posts around them for that.
    private const double MaxStepMetres = 2000;

    // Along a border, rounding must not count as a way towards it: so slowly, a metre takes a thousand kilometres.
    private const double MinRateRadiansPerMetre = 1.6e-13;

    // By the difference over so many metres it is found where the ray goes in latitude and longitude.
    private const double RateMetres = 1;

    /// <summary>The first intersection, or why there is none.</summary>
    public static GeolocationError Intersect(
        in GroundRay ray, in LocalNedFrame frame, TerrainGrid terrain, Angle minDepression, out NedPosition point)
    {
        point = ray.Origin;
        if (double.IsNegativeInfinity(terrain.MaxAltitude.Metres))
            return GeolocationError.NoTerrainData;
        var line = new Line(ray, frame, terrain);
        Place start = line.At(0);
        if (line.ClearanceMetres(0, out double clearance) == TerrainLookup.Known && clearance <= 0)
            return GeolocationError.CameraBelowGround;
        if (!(ray.Depression > minDepression))
            return GeolocationError.NearHorizon;
        GeolocationError error = Traverse(line, start, out double distance);
        point = line.PointAt(distance);
        return error;
    }

    /// <summary>
    /// How much lower the ground is for a metre to the north and to the east; level where it is not known.
    /// </summary>
    public static void Slope(
        in LocalNedFrame frame, TerrainGrid terrain, NedPosition at, out double downByNorth, out double downByEast)
    {
        downByNorth = Slope(frame, terrain, at, new NedVector(1, 0, 0));
        downByEast = Slope(frame, terrain, at, new NedVector(0, 1, 0));
    }

    private static double Slope(in LocalNedFrame frame, TerrainGrid terrain, NedPosition at, NedVector metre)
    {
        bool isKnown =
            terrain.TryAltitude(frame.ToGeodetic(at - metre).Point, out AmslAltitude before) == TerrainLookup.Known;
        isKnown &=
            terrain.TryAltitude(frame.ToGeodetic(at + metre).Point, out AmslAltitude after) == TerrainLookup.Known;
        return isKnown ? (before.Metres - after.Metres) / 2 : 0;
    }

    private static GeolocationError Traverse(in Line line, Place place, out double distance)
    {
        (double reached, double previous) = (0, 0);
        distance = 0;
        while (line.Terrain.TryFindBlock(place.Point, new AmslAltitude(place.AltitudeMetres), out TerrainBlock block))
        {
            Place next = line.At(reached + RateMetres);
            double exit = Math.Min(ExitMetres(place, next, block), MaxStepMetres);
            if (block.IsCell)
            {
                // Lower than the lowest post of the cell there is no ground.
                double lowest = (place.AltitudeMetres - block.MinAltitude.Metres) / line.Descent;
                exit = Math.Min(exit, Math.Max(lowest, 0) + BeyondMetres);
                GeolocationError error = SearchCell(line, previous, reached, exit, block, out distance);
                if (error != GeolocationError.None || distance >= 0)
                    return error;
            }
            else
            {
                // The earth falls away below the ray, never towards it: it goes down at its first rate at most.
                exit = Math.Min(exit, (place.AltitudeMetres - block.MaxAltitude.Metres) / line.Descent);
            }

            bool isRising = next.AltitudeMetres > place.AltitudeMetres;
            if (isRising && place.AltitudeMetres > line.Terrain.MaxAltitude.Metres)
                break;
            previous = reached;
            reached += exit + BeyondMetres;
            place = line.At(reached);
        }

        return GeolocationError.LeavesTerrain;
    }

    // The intersection in a cell between two distances; below 0 if there is none.
    private static GeolocationError SearchCell(
        in Line line, double previous, double from, double length, in TerrainBlock cell, out double distance)
    {
        distance = -1;
        double altitude = line.At(from + length).AltitudeMetres;
        if (altitude > cell.MaxAltitude.Metres)
            return GeolocationError.None;
        if (double.IsNaN(cell.MaxAltitude.Metres))
            return altitude > line.Terrain.MaxAltitude.Metres
                ? GeolocationError.None
                : GeolocationError.NoTerrainData;

        // Over a straight line the bilinear ground is a parabola: three clearances say all of it.
        line.ClearanceMetres(from, out double first);
        if (first <= 0)
            return Narrow(line, previous, from, out distance);
        line.ClearanceMetres(from + (length / 2), out double middle);
        line.ClearanceMetres(from + length, out double last);
        double square = 2 * (first + last - (2 * middle));
        double slope = last - first - square;
        double lowest = -slope / (2 * square);
        if (square > 0 && lowest > 0 && lowest < 1 && line.ClearanceMetres(from + (lowest * length), out double dip)
            == TerrainLookup.Known && dip <= 0)
            return Narrow(line, from, from + (lowest * length), out distance);
        if (middle <= 0)
            return Narrow(line, from, from + (length / 2), out distance);
        return last <= 0 ? Narrow(line, from, from + length, out distance) : GeolocationError.None;
    }

    // How far it is to the border of a block.
    private static double ExitMetres(in Place place, in Place next, in TerrainBlock block)
    {
        double north = (next.Point.Latitude - place.Point.Latitude).Radians / RateMetres;
        double east = (next.Point.Longitude - place.Point.Longitude).Wrapped().Radians / RateMetres;
        double byLatitude = To(place.Point.Latitude, north > 0 ? block.North : block.South, north);
        double byLongitude = To(place.Point.Longitude, east > 0 ? block.East : block.West, east);
        return Math.Max(0, Math.Min(byLatitude, byLongitude));

        static double To(Angle from, Angle border, double rate)
            => Math.Abs(rate) < MinRateRadiansPerMetre ? double.PositiveInfinity : (border - from).Radians / rate;
    }

    // Bisection between a distance above the ground and one below it.
    private static GeolocationError Narrow(in Line line, double above, double below, out double distance)
    {
        while (below - above > ToleranceMetres)
        {
            double middle = (above + below) / 2;
            if (line.ClearanceMetres(middle, out double clearance) == TerrainLookup.Known && clearance <= 0)
                below = middle;
            else
                above = middle;
        }

        distance = (above + below) / 2;
        return GeolocationError.None;
    }

    private readonly struct Place(GeodeticPosition position)
    {
        public GeographicPoint Point { get; } = position.Point;

        public double AltitudeMetres { get; } = position.AltitudeAmslMetres;
    }

    // The ray by distances from its origin.
    private readonly struct Line(GroundRay ray, LocalNedFrame frame, TerrainGrid terrain)
    {
        private readonly LocalNedFrame _frame = frame;
        private readonly NedPosition _origin = ray.Origin;
        private readonly NedVector _direction = ray.Direction.Normalized();

        public TerrainGrid Terrain { get; } = terrain;

        // Metres down for a metre on.
        public double Descent => _direction.Down;

        public NedPosition PointAt(double metres) => _origin + (metres * _direction);

        public Place At(double metres) => new(_frame.ToGeodetic(PointAt(metres)));

        public TerrainLookup ClearanceMetres(double metres, out double clearance)
        {
            Place place = At(metres);
            TerrainLookup answer = Terrain.TryAltitude(place.Point, out AmslAltitude ground);
            clearance = place.AltitudeMetres - ground.Metres;
            return answer;
        }
    }
}
