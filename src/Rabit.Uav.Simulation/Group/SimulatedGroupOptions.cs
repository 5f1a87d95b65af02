using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.Simulation;

/// <summary>What a simulated group of vehicles is like. Read once, when it is made.</summary>
public sealed class SimulatedGroupOptions
{
    /// <summary>The most vehicles.</summary>
    public const int MaxVehicles = 8;

    /// <summary>The most ground stations.</summary>
    public const int MaxGroundStations = 4;

    private const double MaxStationMetres = 1e5;

    /// <summary>
    /// How many vehicles; their system ids are 1, 2 and so on, but for
    /// <see cref="SimulatedGroupFaultKind.SameSystemId"/>.
    /// </summary>
    /// <value>1 to <see cref="MaxVehicles"/>. The default is 3.</value>
    public int Vehicles { get; set; } = 3;

    /// <summary>
    /// The world and its first vehicle. The others stand beside it, 20 m from one to the next, more than five of them
    /// in a second row; errors of their sensors, clocks and batteries are their own.
    /// </summary>
    public SimulationOptions World { get; set; } = new();

    /// <summary>The radio between the vehicles.</summary>
    public SimulatedRadioOptions Radio { get; set; } = new();

    /// <summary>
    /// Ground stations that take part in the radio, at most <see cref="MaxGroundStations"/>; their system ids are 255,
    /// 254 and so on. For <see cref="RadioPartition.Stations"/> they come after the vehicles.
    /// </summary>
    /// <value>The default is none.</value>
    public IReadOnlyList<SimulatedStationPlace> GroundStations { get; set; } = Array.Empty<SimulatedStationPlace>();

    /// <summary>What goes wrong with whole vehicles, in any order.</summary>
    /// <value>The default is nothing.</value>
    public IReadOnlyList<SimulatedGroupFault> Faults { get; set; } = Array.Empty<SimulatedGroupFault>();

    /// <summary>Faults of one vehicle beside those of <see cref="World"/>, by its number from 0.</summary>
    /// <value>The default is none.</value>
    public IReadOnlyDictionary<int, IReadOnlyList<ScriptedFault>> VehicleFaults { get; set; }
        = new Dictionary<int, IReadOnlyList<ScriptedFault>>();

    /// <exception cref="ArgumentException">Options are out of their range; the text names all of them.</exception>
    internal void Validate(string parameter)
    {
        List<string> faults = FindFaults().ToList();
        if (faults.Count > 0)
            throw new ArgumentException("The simulated group: " + string.Join("; ", faults) + ".", parameter);
    }

    private IEnumerable<string> FindFaults()
    {
        if (Vehicles is < 1 or > MaxVehicles)
            yield return $"{nameof(Vehicles)} is {Vehicles}; it must be 1 to {MaxVehicles}";
        if (World is null)
            yield return $"{nameof(World)} is null; it may be left as it is";
        if (Radio is null)
            yield return $"{nameof(Radio)} is null; it may be left as it is";
        foreach (string fault in Radio?.FindFaults(Vehicles + (GroundStations?.Count ?? 0)) ?? [])
            yield return $"{nameof(Radio)}: {fault}";
        foreach (SimulatedGroupFault? fault in Faults ?? [])
        {
            if (fault is null)
            {
                yield return $"{nameof(Faults)} has one that is null";
                continue;
            }

            if (fault.Kind is < SimulatedGroupFaultKind.Lost or > SimulatedGroupFaultKind.SameSystemId)
                yield return $"{nameof(Faults)} has one of kind {fault.Kind}, which there is not";
            if (fault.Vehicle < 0 || fault.Vehicle >= Vehicles)
                yield return $"{nameof(Faults)} has one of vehicle {fault.Vehicle}; they are numbered from 0";
            if (fault.At < TimeSpan.Zero)
                yield return $"{nameof(Faults)} has one at {fault.At}; it must not be negative";
            if (fault.Kind == SimulatedGroupFaultKind.SameSystemId && Vehicles == 1)
                yield return $"{nameof(Faults)} has {fault.Kind}; that takes another vehicle";
        }

        foreach (KeyValuePair<int, IReadOnlyList<ScriptedFault>> own in VehicleFaults
            ?? new Dictionary<int, IReadOnlyList<ScriptedFault>>())
        {
            if (own.Key < 0 || own.Key >= Vehicles)
                yield return $"{nameof(VehicleFaults)} has some of vehicle {own.Key}; they are numbered from 0 to "
                    + (Vehicles - 1);
            if (own.Value is null)
                yield return $"{nameof(VehicleFaults)} has null for vehicle {own.Key}; it may be empty";
        }

        if (GroundStations is null || GroundStations.Count > MaxGroundStations)
            yield return $"{nameof(GroundStations)} has {GroundStations?.Count}; it must have 0 to {MaxGroundStations}";
        foreach (SimulatedStationPlace? station in GroundStations ?? [])
        {
            // Comparisons with NaN are false.
            if (!(Math.Abs(station?.NorthMetres ?? double.NaN) <= MaxStationMetres)
                || !(Math.Abs(station!.EastMetres) <= MaxStationMetres))
                yield return $"{nameof(GroundStations)} has one at {station}; it must be within {MaxStationMetres} m";
        }

        if (Faults is null || VehicleFaults is null)
            yield return $"{nameof(Faults)} or {nameof(VehicleFaults)} is null; they may be empty";
    }
}
