using System;
using Rabit.Benchmarks.Uav;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;

namespace Rabit.Vision.Speed;

/// <summary>
/// A pixel that looks 2.7 degrees below the horizon across <see cref="TerrainWithPeak"/>: the whole way to the ground
/// lies below the highest post of the grid.
/// </summary>
internal sealed class TerrainPixel
{
    private const double Column = 319.5;
    private const double Row = 239.5;

    private readonly PixelGeolocator _locator;
    private readonly ImagingCommand _command = new()
    {
        CameraPitch = Angle.FromDegrees(-2.7),
        CameraYaw = Angle.FromDegrees(50),
    };

    public TerrainPixel()
    {
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
            Terrain = TerrainWithPeak.Make(),
            MinDepression = Angle.FromDegrees(1),
        });
        _locator.Add(new PoseSample { Kind = PoseSampleKind.Position, Position = TerrainWithPeak.Viewer });
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
        NedPosition ground = LocalNedFrame.IgnoringGeoid(TerrainWithPeak.Viewer).ToNed(place.Position);
        Kilometres = NedPosition.Origin.HorizontalDistanceTo(ground) / 1000;
    }
}
