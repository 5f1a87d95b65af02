using System;

namespace Rabit.Vision;

/// <summary>
/// Finds what may be a panel of one or two colours: pixels of its colours, against the ground around them, joined to
/// one part whatever lies beside what in it, with an outline and with bare ground around. Memory that is used again:
/// nothing is allocated for further pictures of a size. One thread.
/// </summary>
/// <example>
/// <code>
/// var colours = new PanelColours(new ColourRange(20, 20, 20), new ColourRange(240, 240, 240));
/// var finder = new PanelFinder();
/// var limits = new PanelLimits { MinSide = 8, MaxSide = 16, UsualSide = 12 };
/// foreach (PanelShape panel in finder.Find(picture.Pixels, picture.Width, picture.Height, colours, limits))
///     Console.WriteLine($"{panel.CoveredRing:0.00} of the ring covered at {panel.CentreX}, {panel.CentreY}");
/// </code>
/// </example>
public sealed class PanelFinder
{
    /// <summary>How many of a picture are kept.</summary>
    public const int MaxPanels = 2048;

    // What is found of a panel at least, by the area of the smallest; and the box around one, by its side: of a square
    // that stands on its corner, and of one that is seen aslant.
    private const double MinSeenArea = 0.35;
    private const double MaxBoxSide = 1.5;
    private const double MinBoxSide = 0.6;

    // The ring around it that is no bare ground, and what of each colour is seen: less of it is none.
    private const double MaxCoveredRing = 0.25;
    private const double MinShare = 0.05;

    // Its ground is the median of tiles of so many sides.
    private const double TileSides = 3;

    // Colours that lie side by side are joined over a pixel, or two where the panel is large.
    private const double LargeSide = 14;

    // What bleaches to white is white, whatever the ground.
    private const float White = 1000;

    // Pixels of white have no colour; that of paper in the shade of the sky is less.
    private const int WhiteChromaShare = 3;

    // A JPEG spreads the colour of a panel over the ground beside it, and in warm light dry grass is yellow: what is of
    // a panel has twice the chroma of the ground, or nearly half of the nominal one, which is as much in its own shade.
    private const float MinChromaByGround = 2.0f;

    private readonly GroundLevels _ground = new();
    private readonly GroundLevels _groundChroma = new(ofChroma: true);
    private readonly PixelMask _parts = new();
    private readonly PixelMask _mask = new();
    private readonly PanelMeasure _measure = new();
    private readonly PanelShape[] _panels = new PanelShape[MaxPanels];
    private int[] _queue = [];

    /// <summary>Those of the last picture that had no room.</summary>
    public int Dropped { get; private set; }

    /// <summary>Finds them.</summary>
    /// <param name="pixels">Red, green, blue, row by row.</param>
    /// <param name="width">Columns.</param>
    /// <param name="height">Rows.</param>
    /// <param name="colours">Of the panel.</param>
    /// <param name="limits">Its size.</param>
    /// <returns>From the top; valid until the next picture.</returns>
    /// <exception cref="ArgumentException">The buffer is too small for the size.</exception>
    public ReadOnlySpan<PanelShape> Find(
        byte[] pixels, int width, int height, PanelColours colours, PanelLimits limits)
    {
        PixelBuffer.Check(pixels, width, height);
        if (colours is null)
            throw new ArgumentNullException(nameof(colours));
        if (colours.HasNeutral)
            _ground.Measure(pixels, width, height, TileSides * limits.UsualSide);
        if (colours.HasHue)
            _groundChroma.Measure(pixels, width, height, TileSides * limits.UsualSide);
        _parts.Resize(width, height);
        _mask.Resize(width, height);
        if (_queue.Length < width * height)
            _queue = new int[width * height];
        for (int row = 0; row < height; row++)
            Mark(pixels, width, height, row, colours);
        _mask.Close(limits.UsualSide < LargeSide ? 1 : 2);
        _measure.Begin(pixels, width, height, _parts, _mask, limits.MeasuresForm);
        Dropped = 0;
        int count = 0;
        for (int row = 0; row < height; row++)
        {
            int first = _mask.At(0, row);
            for (int at = first; at < first + width; at++)
            {
                if (_mask.Bytes[at] != 1)
                    continue;
                int length = Fill(at, out PanelShape shape);
                if (!IsPossible(shape, length, limits))
                    Leave(length);
                else if (IsPanel(_measure.Measure(shape, _queue, length), colours))
                    Keep(_measure.Measured, ref count);
            }
        }

        return new ReadOnlySpan<PanelShape>(_panels, 0, count);
    }

    /// <summary>
    /// Points of the outline of a panel of the last picture: the first and the last pixel of each of its rows.
    /// </summary>
    /// <param name="panel">One of those that were found.</param>
    public ReadOnlySpan<PicturePoint> OutlineOf(in PanelShape panel) => _measure.Outline(panel);

    private static bool IsPossible(in PanelShape shape, int pixels, in PanelLimits limits)
        => pixels >= MinSeenArea * limits.MinSide * limits.MinSide
            && Math.Max(shape.Width, shape.Height) <= MaxBoxSide * limits.MaxSide
            && Math.Min(shape.Width, shape.Height) >= MinBoxSide * limits.MinSide;

    private void Mark(byte[] pixels, int width, int height, int row, PanelColours colours)
    {
        float[] ground = colours.HasNeutral ? _ground.Row(row, width, height) : [];
        byte[] table = colours.Table;
        (byte dark, byte bright) = (colours.DarkPart, colours.BrightPart);
        int to = _parts.At(0, row);
        int from = row * width * 3;
        for (int column = 0; column < width; column++, from += 3, to++)
        {
            (int red, int green, int blue) = (pixels[from], pixels[from + 1], pixels[from + 2]);
            int level = red + (2 * green) + blue;
            byte part = table[
                (red >> (8 - PanelColours.Bits) << (2 * PanelColours.Bits))
                | (green >> (8 - PanelColours.Bits) << PanelColours.Bits) | (blue >> (8 - PanelColours.Bits))];
            if (part != 0)
            {
                int chroma = GroundLevels.ChromaOf(red, green, blue);
                if (chroma < colours.ChromaThatSuffices(part)
                    && chroma < MinChromaByGround * _groundChroma.At(column, row, width, height))
                    part = 0;
            }

            if (dark != 0 && level < PanelColours.MaxDarkByGround * ground[column])
                part = dark;
            else if (bright != 0 && part == 0
                && level > Math.Min(PanelColours.MinBrightByGround * ground[column], White)
                && IsWhite(red, green, blue))
                part = bright;
            _parts.Bytes[to] = part;
            _mask.Bytes[to] = (byte)(part == 0 ? 0 : 1);
        }
    }

    private static bool IsWhite(int red, int green, int blue)
    {
        int most = Math.Max(red, Math.Max(green, blue));
        return (most - Math.Min(red, Math.Min(green, blue))) * WhiteChromaShare < most;
    }

    // Four neighbours; what was taken is 2 until it is left.
    private int Fill(int start, out PanelShape shape)
    {
        byte[] mask = _mask.Bytes;
        (int left, int right, int top, int bottom) = (int.MaxValue, -1, int.MaxValue, -1);
        int length = 0;
        Take(mask, start, ref length);
        for (int i = 0; i < length; i++)
        {
            int at = _queue[i];
            (int column, int row) = _mask.PixelAt(at);
            (left, right) = (Math.Min(left, column), Math.Max(right, column));
            (top, bottom) = (Math.Min(top, row), Math.Max(bottom, row));
            Take(mask, at - 1, ref length);
            Take(mask, at + 1, ref length);
            Take(mask, at - _mask.Stride, ref length);
            Take(mask, at + _mask.Stride, ref length);
        }

        shape = new PanelShape { Left = left, Top = top, Width = right - left + 1, Height = bottom - top + 1 };
        return length;
    }

    private void Take(byte[] mask, int at, ref int length)
    {
        if (mask[at] != 1)
            return;
        mask[at] = PanelMeasure.Taken;
        _queue[length++] = at;
    }

    private static bool IsPanel(in PanelShape shape, PanelColours colours)
        => shape.CoveredRing <= MaxCoveredRing && shape.FirstShare >= MinShare
            && (colours.Second is null || shape.SecondShare >= MinShare);

    private void Keep(in PanelShape shape, ref int count)
    {
        if (count == MaxPanels)
        {
            Dropped++;
            return;
        }

        _panels[count++] = shape;
        _measure.KeepOutline();
    }

    private void Leave(int length)
    {
        for (int i = 0; i < length; i++)
            _mask.Bytes[_queue[i]] = PanelMeasure.Left;
    }
}
