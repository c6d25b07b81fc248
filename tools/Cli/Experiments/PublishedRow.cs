namespace Glint.Cli;

/// <summary>A row of a published table.</summary>
/// <param name="Step">Turn of the target in degrees, or number of the snapshot.</param>
/// <param name="Amplitude">Linear.</param>
sealed record PublishedRow(double Step, double Amplitude, long RaysReceived, long RaysHit)
{
    public double Ratio => RaysHit > 0 ? (double)RaysReceived / RaysHit : 0;
}
