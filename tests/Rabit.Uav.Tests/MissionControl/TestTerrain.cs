using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>Terrain around a place, by a formula.</summary>
internal static class TestTerrain
{
    /// <summary>A grid of 2 km around home with posts about every 10 m.</summary>
    /// <param name="home">The middle; its altitude is that of the ground at height 0.</param>
    /// <param name="heightMetres">Ground above home by metres north and east; NaN where there is none.</param>
    /// <param name="postMetres">Distance of the posts.</param>
    /// <param name="halfMetres">From the middle to the border.</param>
    public static TerrainGrid Around(
        GeodeticPosition home, Func<double, double, double> heightMetres, double postMetres = 10,
        double halfMetres = 1000)
    {
        var frame = LocalNedFrame.IgnoringGeoid(home);
        GeodeticPosition southWest = frame.ToGeodetic(new NedPosition(-halfMetres, -halfMetres, 0));
        GeodeticPosition next = frame.ToGeodetic(
            new NedPosition(postMetres - halfMetres, postMetres - halfMetres, 0));
        Angle latitudeStep = next.Latitude - southWest.Latitude;
        Angle longitudeStep = next.Longitude - southWest.Longitude;
        int posts = (int)(2 * halfMetres / postMetres) + 1;
        var altitudes = new float[posts * posts];
        for (int i = 0; i < altitudes.Length; i++)
        {
            var post = new GeographicPoint(
                southWest.Latitude + (i / posts * latitudeStep), southWest.Longitude + (i % posts * longitudeStep));
            NedPosition at = frame.ToNed(new GeodeticPosition(post, home.Altitude));
            altitudes[i] = (float)(home.AltitudeAmslMetres + heightMetres(at.North, at.East));
        }

        return new TerrainGrid(southWest.Point, latitudeStep, longitudeStep, posts, posts, altitudes);
    }
}
