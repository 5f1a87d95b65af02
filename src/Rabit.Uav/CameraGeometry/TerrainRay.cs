using System;
using Rabit.Geodesy;

namespace Rabit.Uav.CameraGeometry;

/// <summary>Where a line of sight first meets a grid of heights.</summary>
internal static class TerrainRay
{
    // Ridges between two steps are missed: less than the finest grids have between two posts.
    private const double StepMetres = 0.5;
    private const double ClosestMetres = 1e-5;

    /// <summary>The first meeting, or why there is none.</summary>
    public static GeolocationError Intersect(in GroundRay ray, in LocalNedFrame frame, TerrainGrid terrain, double minimumDepressionRadians, out NedVector point)
    {
        point = ray.FromMetres;
        GeolocationError start = Clearance(frame, terrain, point, out double clearance, out double aboveAll);
        if (start == GeolocationError.None && clearance <= 0 && aboveAll <= 0)
            return GeolocationError.CameraBelowGround;
        if (!(ray.DepressionRadians > minimumDepressionRadians))
            return GeolocationError.NearHorizon;
        NedVector direction = Unit(ray.Direction);
        double reached = 0;
        while (true)
        {
            // Down to the highest post nothing can be met; the earth falls away below the line, never towards it.
            double next = reached + Math.Max(StepMetres, aboveAll / direction.Down);
            GeolocationError refusal = Clearance(frame, terrain, At(ray.FromMetres, direction, next), out clearance, out aboveAll);
            if (refusal != GeolocationError.None)
                return refusal;
            if (aboveAll <= 0 && clearance <= 0)
            {
                point = Narrow(ray.FromMetres, direction, frame, terrain, reached, next);
                return GeolocationError.None;
            }

            reached = next;
        }
    }

    /// <summary>How much lower the ground is for a metre to the north and to the east; level where it is not known.</summary>
    public static void Slope(in LocalNedFrame frame, TerrainGrid terrain, NedVector at, out double downByNorth, out double downByEast)
    {
        downByNorth = Slope(frame, terrain, new NedVector(at.North - 1, at.East, at.Down), new NedVector(at.North + 1, at.East, at.Down));
        downByEast = Slope(frame, terrain, new NedVector(at.North, at.East - 1, at.Down), new NedVector(at.North, at.East + 1, at.Down));
    }

    private static double Slope(in LocalNedFrame frame, TerrainGrid terrain, NedVector before, NedVector after)
    {
        bool isKnown = terrain.TryHeight(frame.ToGeodetic(before).Point, out double first) == TerrainLookup.Known;
        isKnown &= terrain.TryHeight(frame.ToGeodetic(after).Point, out double second) == TerrainLookup.Known;
        return isKnown ? (first - second) / 2 : 0;
    }

    // Where the ground may be met it must be known; high above all of it, it need not.
    private static GeolocationError Clearance(in LocalNedFrame frame, TerrainGrid terrain, NedVector point, out double clearance, out double aboveAll)
    {
        GeodeticPosition place = frame.ToGeodetic(point);
        aboveAll = place.AltitudeAmslMetres - terrain.HighestMetres;
        TerrainLookup answer = terrain.TryHeight(place.Point, out double ground);
        clearance = place.AltitudeAmslMetres - ground;
        if (answer == TerrainLookup.Outside)
            return GeolocationError.LeavesTerrain;
        return answer == TerrainLookup.NoData && aboveAll <= 0 ? GeolocationError.NoTerrainData : GeolocationError.None;
    }

    private static NedVector Narrow(NedVector from, NedVector direction, in LocalNedFrame frame, TerrainGrid terrain, double above, double below)
    {
        while (below - above > ClosestMetres)
        {
            double middle = (above + below) / 2;
            GeolocationError refusal = Clearance(frame, terrain, At(from, direction, middle), out double clearance, out _);
            if (refusal == GeolocationError.None && clearance <= 0)
                below = middle;
            else
                above = middle;
        }

        return At(from, direction, (above + below) / 2);
    }

    private static NedVector At(NedVector from, NedVector direction, double metres)
        => new(from.North + (metres * direction.North), from.East + (metres * direction.East), from.Down + (metres * direction.Down));

    private static NedVector Unit(NedVector v)
    {
        double length = Math.Sqrt((v.North * v.North) + (v.East * v.East) + (v.Down * v.Down));
        return new NedVector(v.North / length, v.East / length, v.Down / length);
    }
}
