using System;

namespace Rabit.Vision.Tests.Markers;

/// <summary>
/// Draws a marker, turned by any angle, into a grey picture: 4 x 4 samples a pixel, over twice its width, as blur.
/// </summary>
internal static class DrawnMarker
{
    public const byte Black = 30;
    public const byte White = 220;
    private const int Samples = 4;

    /// <summary>A picture of a marker with one cell of white around it.</summary>
    /// <param name="size">Columns and rows.</param>
    /// <param name="dictionary">Of the marker.</param>
    /// <param name="id">Its id.</param>
    /// <param name="side">Of the black square, pixels.</param>
    /// <param name="angle">Clockwise, radians.</param>
    /// <param name="isMirrored">As seen from behind.</param>
    /// <param name="quietCells">White cells around it.</param>
    /// <param name="ground">Grey of what is around that.</param>
    public static byte[] Draw(
        int size, MarkerDictionary dictionary, int id, double side, double angle, bool isMirrored = false,
        double quietCells = 1, byte ground = 120)
    {
        byte[] grey = new byte[size * size];
        double centre = (size - 1) / 2.0;
        double cell = side / dictionary.Cells;
        (double cos, double sin) = (Math.Cos(angle), Math.Sin(angle));
        for (int pixel = 0; pixel < grey.Length; pixel++)
        {
            int sum = 0;
            for (int sample = 0; sample < Samples * Samples; sample++)
            {
                double x = (pixel % size) - centre + (2 * (((sample % Samples) + 0.5) / Samples)) - 1;
                double y = (pixel / size) - centre + (2 * (((sample / Samples) + 0.5) / Samples)) - 1;
                double u = ((x * cos) + (y * sin)) / cell;
                double v = ((y * cos) - (x * sin)) / cell;
                sum += GreyAt(dictionary, id, isMirrored ? -u : u, v, quietCells, ground);
            }

            grey[pixel] = (byte)(sum / (Samples * Samples));
        }

        return grey;
    }

    /// <summary>Where a corner of it is: 0 for the top left of the upright marker, and on clockwise.</summary>
    public static PicturePoint Corner(int size, double side, double angle, int corner)
    {
        double x = corner is 1 or 2 ? side / 2 : -side / 2;
        double y = corner >= 2 ? side / 2 : -side / 2;
        double centre = (size - 1) / 2.0;
        return new PicturePoint(
            centre + (x * Math.Cos(angle)) - (y * Math.Sin(angle)),
            centre + (x * Math.Sin(angle)) + (y * Math.Cos(angle)));
    }

    private static byte GreyAt(MarkerDictionary dictionary, int id, double u, double v, double quiet, byte ground)
    {
        double half = dictionary.Cells / 2.0;
        double far = Math.Max(Math.Abs(u), Math.Abs(v));
        if (far > half + quiet)
            return ground;
        if (far > half)
            return White;
        int column = (int)Math.Floor(u + half) - 1;
        int row = (int)Math.Floor(v + half) - 1;
        int payload = dictionary.PayloadSide;
        if (column < 0 || row < 0 || column >= payload || row >= payload)
            return Black;
        int bit = (payload * payload) - 1 - ((row * payload) + column);
        return ((dictionary.CodeOf(id) >> bit) & 1) != 0 ? White : Black;
    }
}
