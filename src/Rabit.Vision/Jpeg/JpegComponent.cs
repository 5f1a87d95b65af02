using System;

namespace Rabit.Vision;

/// <summary>One component of a JPEG: brightness or colour, with its samples as far as they are decoded.</summary>
internal sealed class JpegComponent
{
    // So far are samples read and written past the last one, sixteen at a time.
    private const int Slack = 64;

    public int Id { get; set; }

    public int Horizontal { get; set; }

    public int Vertical { get; set; }

    public int QuantisationTable { get; set; }

    public int DcTable { get; set; }

    public int AcTable { get; set; }

    /// <summary>The last DC coefficient, to which the next is a difference.</summary>
    public int Predictor { get; set; }

    public bool IsDecoded { get; set; }

    /// <summary>Columns that are not padding.</summary>
    public int Width { get; private set; }

    /// <summary>Rows that are not padding.</summary>
    public int Height { get; private set; }

    /// <summary>Columns with padding.</summary>
    public int Stride { get; private set; }

    public byte[] Samples { get; private set; } = [];

    /// <summary>Makes room for the samples.</summary>
    public void Arrange(JpegHeader header)
    {
        Width = CeilingOf(header.Width * Horizontal, header.MaxHorizontal);
        Height = CeilingOf(header.Height * Vertical, header.MaxVertical);
        Stride = header.UnitsAcross * Horizontal * 8;
        int needed = (Stride * header.UnitsDown * Vertical * 8) + Slack;
        if (Samples.Length < needed)
            Samples = new byte[needed];
    }

    public static int CeilingOf(int number, int divisor) => (number + divisor - 1) / divisor;
}
