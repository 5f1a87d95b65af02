namespace Rabit.Geodesy;

/// <summary>A position in the earth-centred, earth-fixed frame of WGS-84. A plain value.</summary>
/// <param name="xMetres">Towards latitude 0, longitude 0.</param>
/// <param name="yMetres">Towards latitude 0, longitude 90 degrees east.</param>
/// <param name="zMetres">Towards the north pole.</param>
public readonly struct EcefPosition(double xMetres, double yMetres, double zMetres)
{
    /// <summary>Towards latitude 0, longitude 0.</summary>
    public double XMetres { get; } = xMetres;

    /// <summary>Towards latitude 0, longitude 90 degrees east.</summary>
    public double YMetres { get; } = yMetres;

    /// <summary>Towards the north pole.</summary>
    public double ZMetres { get; } = zMetres;
}
