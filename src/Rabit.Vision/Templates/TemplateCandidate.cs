namespace Rabit.Vision;

/// <summary>A place whose score is the largest around it, and which window it is.</summary>
internal struct TemplateCandidate
{
    public TemplateMatch Match;
    public int Heading;
    public int Row;
    public int Column;
    public bool IsTaken;
}
