using System;
using Rabit.Geodesy;

namespace Rabit.Uav.SensorFusion.Moving;

/// <summary>
/// The sources whose registration errors a filter considers. A source is taken to be as wrong as its first
/// measurement states. Where there are more sources than room, the errors of the further ones count as random.
/// </summary>
internal sealed class RegistrationSlots
{
    /// <summary>How many sources there is room for: the vehicles of a group.</summary>
    public const int Capacity = 8;

    private readonly byte[] _sources = new byte[Capacity];
    private readonly HorizontalCovariance[] _covariances = new HorizontalCovariance[Capacity];

    /// <summary>How many sources there are.</summary>
    public int Count { get; private set; }

    /// <summary>The covariance of the registration error of a source.</summary>
    public HorizontalCovariance this[int slot] => _covariances[slot];

    /// <summary>Forgets all.</summary>
    public void Clear() => Count = 0;

    /// <summary>Becomes the same as others.</summary>
    public void CopyFrom(RegistrationSlots other)
    {
        Array.Copy(other._sources, _sources, Capacity);
        Array.Copy(other._covariances, _covariances, Capacity);
        Count = other.Count;
    }

    /// <summary>The slot of a source; -1 where it has none.</summary>
    public int Find(byte source) => Array.IndexOf(_sources, source, 0, Count);

    /// <summary>
    /// The slot of a source, a new one if need be; -1 where there is no room, or it states no registration error.
    /// </summary>
    public int Of(in TrackMeasurement measurement) => Of(measurement.Key.Source, measurement.Registration);

    /// <summary>
    /// The slot of a source, a new one if need be; -1 where there is no room, or it states no registration error.
    /// </summary>
    public int Of(byte source, HorizontalCovariance covariance)
    {
        int slot = Find(source);
        return slot >= 0 ? slot : Add(source, covariance);
    }

    private int Add(byte source, HorizontalCovariance covariance)
    {
        if (Count == Capacity || !(covariance.NorthNorth > 0 || covariance.EastEast > 0))
            return -1;
        (_sources[Count], _covariances[Count]) = (source, covariance);
        return Count++;
    }
}
