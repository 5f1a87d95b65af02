using System;
using System.Linq;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Geodesy.Tests;
using Rabit.Uav.CameraGeometry;

namespace Rabit.Uav.Tests.Geometry;

/// <summary>The cameras and mounts of the reference values.</summary>
internal static class CameraVectors
{
    /// <param name="index">Which one.</param>
    /// <param name="lineTimeSeconds">How long its sensor reads a row.</param>
    public static CameraModel Camera(int index, double lineTimeSeconds = 0)
    {
        JsonElement c = Vectors.Geolocation.Each("cameras").ElementAt(index);
        return new CameraModel
        {
            Width = c.GetProperty("width").GetInt32(),
            Height = c.GetProperty("height").GetInt32(),
            Readout = TimeSpan.FromTicks(
                (long)Math.Round(lineTimeSeconds * c.GetProperty("height").GetInt32() * TimeSpan.TicksPerSecond)),
            FocalX = c.Number("fx"),
            FocalY = c.Number("fy"),
            CentreX = c.Number("cx"),
            CentreY = c.Number("cy"),
            K1 = c.Number("k1"),
            K2 = c.Number("k2"),
            P1 = c.Number("p1"),
            P2 = c.Number("p2"),
            K3 = c.Number("k3"),
        };
    }

    public static CameraMount Mount(JsonElement mount)
    {
        double[] gimbal = mount.Numbers("r_gimbal");
        double[] camera = mount.Numbers("r_cam");
        return new CameraMount
        {
            MisalignmentRoll = Angle.FromDegrees(mount.Number("roll")),
            MisalignmentPitch = Angle.FromDegrees(mount.Number("pitch")),
            MisalignmentYaw = Angle.FromDegrees(mount.Number("yaw")),
            GimbalLeverArmMetres = new BodyVector(gimbal[0], gimbal[1], gimbal[2]),
            CameraLeverArmMetres = new BodyVector(camera[0], camera[1], camera[2]),
        };
    }
}
