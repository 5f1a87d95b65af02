using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;

namespace Rabit.Vision.Speed;

/// <summary>
/// A pixel that looks from 1600 m, 2.7 degrees below the horizon, across a grid of one degree with one post of 3400 m:
/// the whole way to the ground lies below the highest post of the grid.
/// </summary>
internal sealed class TerrainPixel
{
    private const int Posts = 1201;
    private const double Column = 319.5;
    private const double Row = 239.5;

    private static readonly Angle Step = Angle.FromDegrees(1.0 / 1200);
    private static readonly GeodeticPosition Vehicle = GeodeticPosition.FromDegrees(47.1, 8.2, 1600);

    private readonly PixelGeolocator _locator;
    private readonly ImagingCommand _command = new()
    {
        CameraPitch = Angle.FromDegrees(-2.7),
        CameraYaw = Angle.FromDegrees(50),
    };

    public TerrainPixel()
    {
        float[] posts = new float[Posts * Posts];
        for (int i = 0; i < posts.Length; i++)
            posts[i] = 100 + (i % 7);
        posts[posts.Length - 1000] = 3400;
        _locator = new PixelGeolocator(new ImageProcessingOptions
        {
            Camera = new CameraModel
            {
                Width = 640,
                Height = 480,
                FocalX = 530,
                FocalY = 530,
                CentreX = Column,
                CentreY = Row,
            },
            Mount = new CameraMount(),
            Terrain = new TerrainGrid(
                new GeographicPoint(Angle.FromDegrees(47), Angle.FromDegrees(8)), Step, Step, Posts, Posts, posts),
            MinDepression = Angle.FromDegrees(1),
        });
        _locator.Add(new PoseSample { Kind = PoseSampleKind.Position, Position = Vehicle });
        _locator.Add(new PoseSample { Kind = PoseSampleKind.Attitude });
        Locate();
    }

    /// <summary>How far away it is.</summary>
    public double Kilometres { get; private set; }

    /// <exception cref="InvalidOperationException">It has no place.</exception>
    public void Locate()
    {
        GeolocationResult place = _locator.Locate(default, _command, Column, Row);
        if (place.Error != GeolocationError.None)
            throw new InvalidOperationException($"The pixel has no place: {place.Error}.");
        NedPosition ground = LocalNedFrame.IgnoringGeoid(Vehicle).ToNed(place.Position);
        Kilometres = NedPosition.Origin.HorizontalDistanceTo(ground) / 1000;
    }
}
