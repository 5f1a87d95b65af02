namespace OrderBugSearch;

internal struct Button
{
    public bool IsPressed;
}

internal struct ValveState
{
    public bool IsOpen;
}
