namespace Rabit.Uav.Simulation;

/// <summary>One channel of a picture in whole blocks of 8 by 8; what is beyond the picture repeats its edge.</summary>
internal sealed class JpegPlane(int width, int height)
{
    public int Stride { get; } = (width + 7) / 8 * 8;

    public int Rows { get; } = (height + 7) / 8 * 8;

    public double[] Levels { get; } = new double[(width + 7) / 8 * 8 * ((height + 7) / 8 * 8)];

    /// <summary>Fills what is beyond the picture.</summary>
    public void Pad()
    {
        for (int v = 0; v < Rows; v++)
        {
            int from = (v < height ? v : height - 1) * Stride;
            for (int u = v < height ? width : 0; u < Stride; u++)
                Levels[(v * Stride) + u] = Levels[from + (u < width ? u : width - 1)];
        }
    }
}
