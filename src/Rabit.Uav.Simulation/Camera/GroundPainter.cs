using System;
using System.Runtime.CompilerServices;
#if NET
using System.Runtime.Intrinsics.X86;
#endif

namespace Rabit.Uav.Simulation;

/// <summary>
/// Paints ground and sky: for each pixel the ray through the lens, met with the flat ground. Allocates nothing.
/// </summary>
internal sealed partial class GroundPainter(LensRays lens, GroundTexture texture)
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

#if NET
    /// <summary>Whether several bytes are made at a time, where the processor can; the bytes are the same.</summary>
    public bool UsesVectors { get; set; } = Avx2.IsSupported;
#endif

    public void Paint(in CameraPose pose, byte[] pixels)
    {
        int count = lens.Width * lens.Height;
        if (pose.Height < MinHeight)
        {
            Fill(pixels, count * 3);
            return;
        }

        var view = new GroundView(pose, lens.Focal);
        int painted = 0;
#if NET
        if (UsesVectors)
            painted = PaintFours(view, pixels, count);
#endif
        PaintOnes(view, pixels, painted, count);
    }

    private void PaintOnes(in GroundView view, byte[] pixels, int from, int end)
    {
        double[] rays = lens.Rays;
        int to = 3 * from;
        for (int i = from; i < end; i++)
        {
            double x = rays[2 * i];
            double y = rays[(2 * i) + 1];
            double down = (x * view.Right.Third) + (y * view.Below.Third) + view.Axis.Third;
            uint colour = down < view.MinDown ? SkyAt(down, x, y) : GroundAt(view, down, x, y);
            pixels[to] = (byte)(colour >> 16);
            pixels[to + 1] = (byte)(colour >> 8);
            pixels[to + 2] = (byte)colour;
            to += 3;
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private uint GroundAt(in GroundView view, double down, double x, double y)
    {
        double along = view.Height / down;
        double north = view.North + (along * ((x * view.Right.First) + (y * view.Below.First) + view.Axis.First));
        double east = view.East + (along * ((x * view.Right.Second) + (y * view.Below.Second) + view.Axis.Second));
        double grain = view.GrainPerDown * down;
        uint colour = texture.ColourAt(
            north, east, grain < GroundTexture.AllGrain ? (int)grain : GroundTexture.AllGrain);
        return along > HazeFrom
            ? Mix(colour, Haze, (along - HazeFrom) / (MaxGroundDistance - HazeFrom))
            : colour;
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

    // A camera over the ground, in what does not change from pixel to pixel.
    private readonly struct GroundView(in CameraPose pose, double focal)
    {
        public readonly Vector3 Axis = pose.Axes.Forward;
        public readonly Vector3 Right = pose.Axes.Right;
        public readonly Vector3 Below = pose.Axes.Down;
        public readonly double Height = pose.Height;

        // In the texture's first period, metres.
        public readonly double North = InPeriod(pose.North);
        public readonly double East = InPeriod(pose.East);

        // A ray that goes down less is in the sky.
        public readonly double MinDown = pose.Height / MaxGroundDistance;
        public readonly double GrainPerDown = GroundTexture.AllGrain * GrainMetres * focal / pose.Height;

        private static double InPeriod(double metres)
            => metres - (GroundTexture.Period * Math.Floor(metres / GroundTexture.Period));
    }
}
