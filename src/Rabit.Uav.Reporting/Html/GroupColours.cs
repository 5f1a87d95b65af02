namespace Rabit.Uav.Reporting.Html;

/// <summary>Each vehicle of a group has a colour, the same in the map, the tables and the time lines.</summary>
internal static class GroupColours
{
    private const int Colours = 8;

    /// <summary>The class of the style sheet of a vehicle, by its place in the list.</summary>
    public static string Class(int vehicle) => "v" + FlightText.Number((vehicle % Colours) + 1L);

    /// <summary>A square of that colour, and the name of the vehicle.</summary>
    public static void WriteName(PageWriter page, int vehicle, byte systemId)
        => page.Element("i", string.Empty, "class", "dot " + Class(vehicle)).Text(Name(systemId));

    /// <summary>The name of a vehicle.</summary>
    public static string Name(byte systemId) => "vehicle " + FlightText.Number((long)systemId);
}
