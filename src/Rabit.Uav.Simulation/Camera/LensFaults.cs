using System;
using System.Collections.Generic;

namespace Rabit.Uav.Simulation;

/// <summary>
/// What is wrong with lens, shutter or mount, before the noise of the sensor; too much light after it. One thread.
/// </summary>
internal sealed class LensFaults(int width, int height)
{
    private const double DefaultBlur = 4;
    private const double DefaultSmear = 17;
    private const double DefaultCover = 0.5;

    // What a sensor gives without light.
    private const byte BlackLevel = 4;

    // A cover near the lens: dark, and its edge out of focus over a part of the width.
    private const int CoverLevel = 28;
    private const double CoverEdge = 0.06;

    private byte[]? _copy;

    public void Apply(IReadOnlyList<ScriptedFault> faults, byte[] pixels)
    {
        for (int i = 0; i < faults.Count; i++)
            Apply(faults[i], pixels);
    }

    /// <summary>All levels at their upper end, where a fault says so.</summary>
    public static void Overexpose(IReadOnlyList<ScriptedFault> faults, byte[] pixels)
    {
        for (int i = 0; i < faults.Count; i++)
        {
            if (faults[i].Kind == ScriptedFaultKind.PicturesWhite)
                Fill(pixels, byte.MaxValue);
        }
    }

    private void Apply(in ScriptedFault fault, byte[] pixels)
    {
        switch (fault.Kind)
        {
            case ScriptedFaultKind.PicturesBlack:
                Fill(pixels, BlackLevel);
                break;
            case ScriptedFaultKind.PicturesDefocused:
                int reach = (int)(fault.Value > 0 ? fault.Value : DefaultBlur);
                for (int pass = 0; pass < 2; pass++)
                {
                    Blur(pixels, reach, step: 3, lines: height, lineStep: 3 * width, length: width);
                    Blur(pixels, reach, step: 3 * width, lines: width, lineStep: 3, length: height);
                }

                break;
            case ScriptedFaultKind.PicturesMotionBlurred:
                int half = (int)((fault.Value > 0 ? fault.Value : DefaultSmear) / 2);
                Blur(pixels, half, step: 3 * width, lines: width, lineStep: 3, length: height);
                break;
            case ScriptedFaultKind.PicturesCovered:
                Cover(pixels, fault.Value > 0 ? fault.Value : DefaultCover);
                break;
        }
    }

    private static void Fill(byte[] pixels, byte level)
    {
        for (int at = 0; at < pixels.Length; at++)
            pixels[at] = level;
    }

    // The mean over a window that moves along each line.
    private void Blur(byte[] pixels, int reach, int step, int lines, int lineStep, int length)
    {
        _copy ??= new byte[pixels.Length];
        Array.Copy(pixels, _copy, pixels.Length);
        for (int line = 0; line < lines; line++)
        {
            for (int channel = 0; channel < 3; channel++)
            {
                int first = (line * lineStep) + channel;
                (int sum, int count) = (0, 0);
                for (int i = -reach; i < length; i++)
                {
                    if (i + reach < length)
                        (sum, count) = (sum + _copy[first + ((i + reach) * step)], count + 1);
                    if (i - reach - 1 >= 0)
                        (sum, count) = (sum - _copy[first + ((i - reach - 1) * step)], count - 1);
                    if (i >= 0)
                        pixels[first + (i * step)] = (byte)(sum / count);
                }
            }
        }
    }

    private void Cover(byte[] pixels, double part)
    {
        for (int column = 0; column < width; column++)
        {
            double open = Math.Max(0, Math.Min(1, 0.5 + (((column / (double)width) - part) / CoverEdge)));
            for (int row = 0; row < height; row++)
            {
                int at = ((row * width) + column) * 3;
                for (int channel = 0; channel < 3; channel++)
                    pixels[at + channel] = (byte)((open * pixels[at + channel]) + ((1 - open) * CoverLevel));
            }
        }
    }
}
