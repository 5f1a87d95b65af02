using System;
using Rabit.Geodesy;

namespace Rabit.Uav.CameraGeometry;

/// <summary>Where a ray first intersects the terrain.</summary>
internal static class TerrainRay
{
    // Ridges between two steps are missed: less than the finest grids have between two posts.
    private const double StepMetres = 0.5;
    private const double ToleranceMetres = 1e-5;

    /// <summary>The first intersection, or why there is none.</summary>
    public static GeolocationError Intersect(
        in GroundRay ray, in LocalNedFrame frame, TerrainGrid terrain, Angle minDepression, out NedPosition point)
    {
        point = ray.Origin;
        GeolocationError start = Clearance(frame, terrain, point, out double clearance, out double aboveAll);
        if (start == GeolocationError.None && clearance <= 0 && aboveAll <= 0)
            return GeolocationError.CameraBelowGround;
        if (!(ray.Depression > minDepression))
            return GeolocationError.NearHorizon;
        NedVector direction = ray.Direction.Normalized();
        double reached = 0;
        while (true)
        {
            // Above the highest post there is no terrain; the earth falls away below the ray, never towards it.
            double next = reached + Math.Max(StepMetres, aboveAll / direction.Down);
            GeolocationError error = Clearance(
                frame, terrain, ray.Origin + (next * direction), out clearance, out aboveAll);
            if (error != GeolocationError.None)
                return error;
            if (aboveAll <= 0 && clearance <= 0)
            {
                point = Narrow(ray.Origin, direction, frame, terrain, reached, next);
                return GeolocationError.None;
            }

            reached = next;
        }
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

    // Where the ray may intersect the ground, its altitude must be known; high above all of it, it need not.
    private static GeolocationError Clearance(
        in LocalNedFrame frame, TerrainGrid terrain, NedPosition point, out double clearance, out double aboveAll)
    {
        GeodeticPosition place = frame.ToGeodetic(point);
        aboveAll = place.AltitudeAmslMetres - terrain.MaxAltitude.Metres;
        TerrainLookup answer = terrain.TryAltitude(place.Point, out AmslAltitude ground);
        clearance = place.AltitudeAmslMetres - ground.Metres;
        if (answer == TerrainLookup.Outside)
            return GeolocationError.LeavesTerrain;
        return answer == TerrainLookup.NoData && aboveAll <= 0 ? GeolocationError.NoTerrainData : GeolocationError.None;
    }

    // Bisection between a distance above the ground and one below it.
    private static NedPosition Narrow(
        NedPosition origin, NedVector direction, in LocalNedFrame frame, TerrainGrid terrain, double above,
        double below)
    {
        while (below - above > ToleranceMetres)
        {
            double middle = (above + below) / 2;
            GeolocationError error = Clearance(
                frame, terrain, origin + (middle * direction), out double clearance, out _);
            if (error == GeolocationError.None && clearance <= 0)
                below = middle;
            else
                above = middle;
        }

        return origin + ((above + below) / 2 * direction);
    }
}
