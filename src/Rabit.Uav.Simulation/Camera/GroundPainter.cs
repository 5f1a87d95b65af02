using System;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Paints ground and sky: for each pixel the ray through the lens, met with the flat ground. Allocates nothing.
/// </summary>
internal sealed class GroundPainter(LensRays lens, GroundTexture texture)
{
    /// <summary>
    /// Below this height above the ground the lens is in the grass: the picture is dark, and nothing is seen.
    /// </summary>
    public const double MinHeight = 0.03;

    private const double MaxGroundDistance = 3000;
    private const double HazeFrom = 250;

    // A pixel that is larger than this on the ground does not resolve the finest grain any more, metres.
    private const double GrainMetres = 0.09;

    private const uint InTheGrass = 0x18_1C_14;
    private const uint Haze = 0xC6_CC_D2;
    private const uint Zenith = 0x8C_A8_CC;

    public void Paint(in CameraPose pose, byte[] pixels)
    {
        if (pose.Height < MinHeight)
        {
            Fill(pixels, lens.Width * lens.Height * 3);
            return;
        }

        Vector3 axis = pose.Axes.Forward;
        Vector3 right = pose.Axes.Right;
        Vector3 below = pose.Axes.Down;
        double height = pose.Height;
        double northFrom = pose.North - (GroundTexture.Period * Math.Floor(pose.North / GroundTexture.Period));
        double eastFrom = pose.East - (GroundTexture.Period * Math.Floor(pose.East / GroundTexture.Period));
        double leastDown = height / MaxGroundDistance;
        double grainPerDown = 256 * GrainMetres * lens.Focal / height;
        double[] rays = lens.Rays;
        int count = lens.Width * lens.Height;
        int to = 0;
        for (int i = 0; i < count; i++)
        {
            double x = rays[2 * i];
            double y = rays[(2 * i) + 1];
            double down = (x * right.Third) + (y * below.Third) + axis.Third;
            uint colour;
            if (down < leastDown)
            {
                colour = SkyAt(down, x, y);
            }
            else
            {
                double along = height / down;
                double north = northFrom + (along * ((x * right.First) + (y * below.First) + axis.First));
                double east = eastFrom + (along * ((x * right.Second) + (y * below.Second) + axis.Second));
                double grain = grainPerDown * down;
                colour = texture.ColourAt(north, east, grain < 256 ? (int)grain : 256);
                if (along > HazeFrom)
                    colour = Mix(colour, Haze, (along - HazeFrom) / (MaxGroundDistance - HazeFrom));
            }

            pixels[to] = (byte)(colour >> 16);
            pixels[to + 1] = (byte)(colour >> 8);
            pixels[to + 2] = (byte)colour;
            to += 3;
        }
    }

    private static uint SkyAt(double down, double x, double y)
    {
        double sine = -down / Math.Sqrt(1 + (x * x) + (y * y));
        return Mix(Haze, Zenith, Math.Max(0, Math.Min(1, 2 * sine)));
    }

    private static uint Mix(uint a, uint b, double part)
    {
        uint weight = (uint)(256 * part);
        uint redBlue = ((((a & 0xFF00FF) * (256 - weight)) + ((b & 0xFF00FF) * weight)) >> 8) & 0xFF00FF;
        uint green = ((((a & 0x00FF00) * (256 - weight)) + ((b & 0x00FF00) * weight)) >> 8) & 0x00FF00;
        return redBlue | green;
    }

    private static void Fill(byte[] pixels, int length)
    {
        for (int at = 0; at < length; at += 3)
        {
            pixels[at] = (byte)(InTheGrass >> 16);
            pixels[at + 1] = (byte)((InTheGrass >> 8) & 0xFF);
            pixels[at + 2] = (byte)(InTheGrass & 0xFF);
        }
    }
}
